// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in a locale with decimal commas: all of one kind, wherever they are shown.
#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QTest>
#include <set>

#include "models/quantity_text.h"
#include "panels/plot/custom_plot.h"
#include "session/shown_number.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::locale_test {

namespace {

/// Everything that a person can read in a window and under its cursor.
class ShownTexts {
public:
    explicit ShownTexts(const QWidget& window) {
        for (const QWidget* widget : window.findChildren<QWidget*>()) {
            add(widget->toolTip());
            add(widget->property("text").toString());
            add(widget->property("title").toString());
            if (const auto* box = qobject_cast<const QDoubleSpinBox*>(widget)) {
                add(box->text());
            } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
                addModel(view->model());
            } else if (auto* plot = qobject_cast<QCustomPlot*>(const_cast<QWidget*>(widget))) {
                addPlot(*plot);
            }
        }
        for (const QAction* action : window.findChildren<QAction*>()) {
            add(action->text());
            add(action->toolTip());
        }
    }
    [[nodiscard]] const std::set<QString>& texts() const { return m_texts; }

private:
    void add(const QString& text) {
        if (!text.isEmpty()) {
            m_texts.insert(text);
        }
    }
    void addModel(const QAbstractItemModel* model, const QModelIndex& parent = {}) {
        for (int row = 0; model != nullptr && row < std::min(model->rowCount(parent), 60); ++row) {
            for (int column = 0; column < model->columnCount(parent); ++column) {
                const QModelIndex index = model->index(row, column, parent);
                add(index.data(Qt::DisplayRole).toString());
                add(index.data(Qt::ToolTipRole).toString());
            }
            addModel(model, model->index(row, 0, parent));
        }
    }
    void addPlot(QCustomPlot& plot) {
        for (int i = 0; i < plot.itemCount(); ++i) {
            if (const auto* text = qobject_cast<QCPItemText*>(plot.item(i))) {
                add(text->text());
            }
        }
        for (const QCPAxis* axis : plot.findChildren<QCPAxis*>()) {
            for (const QString& label : axis->tickVectorLabels()) {
                add(label);
            }
        }
    }

    std::set<QString> m_texts;
};

}  // namespace

class LocaleTest : public QObject, private WindowFixture {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::French, QLocale::France)); }
    void cleanupTestCase() { QLocale::setDefault(QLocale::c()); }
    void cleanup() { dropWindow(); }

    void numbersFollowTheLocale();
    void allNumbersOfTheWindowHaveCommas();
};

void LocaleTest::numbersFollowTheLocale() {
    QCOMPARE(vectorText({1.25f, -0.3f, 0.0f}), QStringLiteral("1,250; -0,300; 0,000"));
    QCOMPARE(copiedVectorText({1.25f, -0.3f, 0.0f}), QStringLiteral("1.250, -0.300, 0.000"));
    QCOMPARE(shownNumber(0.25, 'f', 2), QStringLiteral("0,25"));
    QCOMPARE(quantityText(0.3), QStringLiteral("0,30000"));
    const QLocale::Language english = QLocale::English;
    QLocale::setDefault(QLocale(english));
    QCOMPARE(vectorText({1.25f, -0.3f, 0.0f}), QStringLiteral("1.250, -0.300, 0.000"));
    QLocale::setDefault(QLocale(QLocale::French, QLocale::France));
}

void LocaleTest::allNumbersOfTheWindowHaveCommas() {
    makeWindow();
    Hit hit;
    hit.target = m_session->targets().front()->id;
    hit.point = {0.0f, 0.0f, 2.5f};
    hit.direction = {0.0f, 0.0f, -1.0f};
    hit.speed = 30.25f;
    for (int i = 0; i < 3; ++i) {
        hit.point.x = 0.3f * static_cast<float>(i);
        QVERIFY(m_session->hits().add(hit).ok());
    }
    for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        QTest::qWait(30);
    }
    m_session->hits().select(1);
    m_session->simulation().setTimeScale(0.25);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->targets().front()->deformed.statistics().changedVertices > 0,
                             kPatience);
    QTest::qWait(1000);  // for background work
    const ShownTexts shown(*m_window);
    const QRegularExpression point(QStringLiteral("[0-9]\\.[0-9]"));
    const QRegularExpression mixed(QStringLiteral("[0-9],[0-9]+, -?[0-9]"));
    const QRegularExpression comma(QStringLiteral("[0-9],[0-9]"));
    QStringList wrong;
    int right = 0;
    for (QString text : shown.texts()) {
        text.remove(m_window->viewport().scene().rendererName())
            .remove(m_window->viewport().scene().rendererVersion());
        text.remove(QStringLiteral("OpenGL 3.3")).remove(QStringLiteral("OpenGL 4.3"));
        if (text.contains(point) || text.contains(mixed)) {
            wrong << text;
        }
        right += text.contains(comma) ? 1 : 0;
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    QVERIFY2(right > 60, qPrintable(QString::number(right)));
}

HITSCOPE_TEST(LocaleTest, QApplication)

}  // namespace hitscope::locale_test

#include "locale_test.moc"
