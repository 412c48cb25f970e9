// SPDX-License-Identifier: GPL-3.0-or-later
// No text of the window is cut on a screen of 1280 x 720, in English or in a language of longer words.
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QTabWidget>
#include <QTest>
#include <QTimer>

#include "cut_texts_support.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::text_fits_test {

class TextFitsTest : public QObject, WindowFixture {
    Q_OBJECT
private Q_SLOTS:
    void cleanup() {
        dropWindow();
        QCoreApplication::removeTranslator(&m_longer);
    }

    void nothingIsCut_data() {
        QTest::addColumn<bool>("longer");
        QTest::newRow("English") << false;
        QTest::newRow("40 % longer words") << true;
    }

    void nothingIsCut() {
        QFETCH(const bool, longer);
        if (longer) {
            QCoreApplication::installTranslator(&m_longer);
        }
        makeWindow();
        m_window->setGeometry(0, 0, 1280, 720 - 24);  // less a title bar
        hit();
        QStringList cut = cutTexts(*m_window);
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            settle();
            add(cut, *dock);
            for (QTabWidget* tabs : dock->findChildren<QTabWidget*>()) {
                for (int i = 0; i < tabs->count(); ++i) {
                    tabs->setCurrentIndex(i);
                    settle();
                    add(cut, *dock);
                }
            }
        }
        for (const char* dialog :
             {"Burst", "Sequence", "Scatter Hits", "Mirror Hits", "Brush Settings", "Refine", "Simplify",
              "Smooth", "Projectile", "Save Picture As", "Save Picture Sequence"}) {
            addDialog(cut, QString::fromUtf8(dialog));
        }
        addSeveralTargets(cut);
        cut.removeDuplicates();
        for (const QString& line : cut) {
            qWarning("%s", qPrintable(line));
        }
        QVERIFY(cut.isEmpty());
    }

private:
    /// The Scene panel says more where several are selected.
    void addSeveralTargets(QStringList& cut) {
        const TargetId first = m_session->targets().front()->id;
        m_session->targets().duplicate({&first, 1});
        const std::array both{first, m_session->targets().back()->id};
        m_session->targets().select(first, both);
        const auto* whose = m_window->findChild<QLabel*>(QStringLiteral("whose"));
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            if (dock->isAncestorOf(whose)) {
                dock->show();
                dock->raise();
                settle();
                QVERIFY(whose->isVisible());
                add(cut, *dock);
            }
        }
    }
    void hit() {
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = {0.0f, 2.5f, 0.0f};
        hit.direction = {0.0f, -1.0f, 0.0f};
        QVERIFY(m_session->hits().add(hit).ok());
        QTRY_VERIFY_WITH_TIMEOUT(m_session->targets().front()->deformed.statistics().changedVertices > 0,
                                 kPatience);
        settle();
    }
    static void settle() { QTest::qWait(150); }
    static void add(QStringList& all, const QDockWidget& dock) {
        for (const QString& line : cutTexts(dock)) {
            all.append(dock.objectName() + QStringLiteral(" > ") + line);
        }
    }

    /// What the action whose text begins like that and ends with dots opens, whether it waits for an answer
    /// or not.
    void addDialog(QStringList& all, const QString& begin) {
        bool seen = false;
        QTimer look;
        const auto inspect = [&] {
            for (QWidget* widget : QApplication::topLevelWidgets()) {
                if (auto* dialog = qobject_cast<QDialog*>(widget); dialog != nullptr && dialog->isVisible()) {
                    seen = true;
                    for (const QString& line : cutTexts(*dialog)) {
                        all.append(begin + QStringLiteral(" > ") + line);
                    }
                    dialog->close();
                }
            }
        };
        QObject::connect(&look, &QTimer::timeout, inspect);
        look.start(100);
        for (QAction* action : m_window->findChildren<QAction*>()) {
            if (action->text().remove(u'&').startsWith(begin) && action->text().endsWith(u'…')) {
                action->trigger();
                break;
            }
        }
        QTRY_VERIFY2_WITH_TIMEOUT(seen, qPrintable(begin), kPatience);
        look.stop();
        makeActive(*m_window);
    }

    LongerWords m_longer;
};

HITSCOPE_TEST(TextFitsTest, QApplication)

}  // namespace hitscope::text_fits_test

#include "text_fits_test.moc"
