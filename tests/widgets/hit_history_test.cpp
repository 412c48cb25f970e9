// SPDX-License-Identifier: GPL-3.0-or-later
// The hit history's panel under real mouse and keys.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QWindow>
#include <functional>

#include "panels/hit_history/capacity_meter.h"
#include "panels/hit_history/hit_history_panel.h"
#include "support/read_back.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::hit_history_test {

namespace {

void addHits(Session& session, int count) {
    for (int i = 0; i < count; ++i) {
        const std::size_t made = session.hits().history().size();
        Hit hit;
        hit.target = session.targets()[made % 4]->id;
        hit.point.x = static_cast<float>(made);
        QVERIFY(session.hits().add(hit).ok());
    }
}

std::vector<int> order(const Session& session) {
    std::vector<int> numbers;
    for (const Hit& hit : session.hits().history().hits()) {
        numbers.push_back(static_cast<int>(hit.point.x));
    }
    return numbers;
}

}  // namespace

class HitHistoryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void checkBoxByMouse();
    void spaceTogglesTheSelection();
    void keysMoveTheSelection();
    void keysMoveRowsThatStandApart();
    void deleteIsOneStep();
    void contextMenuActs();
    void rowsAreDragged();
    void severalRowsAreDragged();
    void selectionAndPlaceSurviveChanges();
    void selectsAllOnTheTarget();
    void filterListsManyTargetsAtOnce();
    void summaryAndMeter();
    void hitsThatDoNothingAreGrey();
    void manyRowsAreHandledAtOnce();

private:
    [[nodiscard]] QRect row(int number) const {
        return m_table->visualRect(m_panel->findChild<QTableView*>()->model()->index(number, 2));
    }
    [[nodiscard]] std::vector<int> selected() const;
    [[nodiscard]] QAction* action(const QString& text) const;
    void drag(const QPoint& from, const QPoint& to);

    std::unique_ptr<Session> m_session;
    std::unique_ptr<HitHistoryModel> m_model;
    std::unique_ptr<HitHistoryPanel> m_panel;
    QTableView* m_table = nullptr;
};

void HitHistoryTest::init() {
    m_panel.reset();
    m_model.reset();
    m_session = std::make_unique<Session>();
    loadPaperRow(*m_session, kDefaultPaperRow);
    m_model = std::make_unique<HitHistoryModel>(*m_session);
    m_panel = std::make_unique<HitHistoryPanel>(*m_session, *m_model);
    m_table = m_panel->findChild<QTableView*>();
    m_panel->resize(800, 300);
    m_panel->show();
    makeActive(*m_panel);
    addHits(*m_session, 6);
    m_table->setFocus();
}

std::vector<int> HitHistoryTest::selected() const {
    std::vector<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        rows.push_back(index.row());
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

QAction* HitHistoryTest::action(const QString& text) const {
    for (QAction* action : m_table->actions()) {
        if (action->text() == text) {
            return action;
        }
    }
    return nullptr;
}

void HitHistoryTest::checkBoxByMouse() {
    const QModelIndex number = m_table->model()->index(2, HitHistoryModel::NumberColumn);
    QStyleOptionViewItem option;
    option.initFrom(m_table);
    option.rect = m_table->visualRect(number);
    option.features = QStyleOptionViewItem::HasCheckIndicator | QStyleOptionViewItem::HasDisplay;
    const QRect box =
        m_table->style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, m_table);
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, box.center());
    QVERIFY(!m_session->hits().history().hits()[2].enabled);
    QCOMPARE(m_session->hits().disabled(), std::size_t{1});
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, box.center());
    QCOMPARE(m_session->hits().disabled(), std::size_t{0});
}

void HitHistoryTest::spaceTogglesTheSelection() {
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, row(1).center());
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, Qt::ShiftModifier, row(3).center());
    QTest::keyClick(m_table, Qt::Key_Space);
    QCOMPARE(m_session->hits().disabled(), std::size_t{3});
    QCOMPARE(selected(), (std::vector<int>{1, 2, 3}));
    QTest::keyClick(m_table, Qt::Key_Space);
    QCOMPARE(m_session->hits().disabled(), std::size_t{0});
    m_session->hits().setEnabled(std::vector<std::size_t>{2}, false);
    QTest::keyClick(m_table, Qt::Key_Space);  // some are enabled, so all are disabled
    QCOMPARE(m_session->hits().disabled(), std::size_t{3});
}

void HitHistoryTest::keysMoveTheSelection() {
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, row(2).center());
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, Qt::ShiftModifier, row(3).center());
    QTest::keyClick(m_table, Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(order(*m_session), (std::vector<int>{0, 2, 3, 1, 4, 5}));
    QCOMPARE(selected(), (std::vector<int>{1, 2}));
    QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(2));
    QTest::keyClick(m_table, Qt::Key_Up, Qt::AltModifier);
    QTest::keyClick(m_table, Qt::Key_Up, Qt::AltModifier);  // they are on top
    QCOMPARE(order(*m_session), (std::vector<int>{2, 3, 0, 1, 4, 5}));
    for (int i = 0; i < 5; ++i) {
        QTest::keyClick(m_table, Qt::Key_Down, Qt::AltModifier);
    }
    QCOMPARE(order(*m_session), (std::vector<int>{0, 1, 4, 5, 2, 3}));
    QCOMPARE(selected(), (std::vector<int>{4, 5}));
}

void HitHistoryTest::keysMoveRowsThatStandApart() {
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, row(1).center());
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, Qt::ControlModifier, row(3).center());
    QTest::keyClick(m_table, Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(order(*m_session), (std::vector<int>{1, 0, 3, 2, 4, 5}));
    QCOMPARE(selected(), (std::vector<int>{0, 2}));
    QTest::keyClick(m_table, Qt::Key_Up, Qt::AltModifier);  // one is on top
    QCOMPARE(order(*m_session), (std::vector<int>{1, 3, 0, 2, 4, 5}));
    QCOMPARE(selected(), (std::vector<int>{0, 1}));
    m_session->undo();
    QTest::keyClick(m_table, Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(order(*m_session), (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

void HitHistoryTest::deleteIsOneStep() {
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, row(1).center());
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, Qt::ControlModifier, row(4).center());
    QTest::keyClick(m_table, Qt::Key_Delete);
    QCOMPARE(order(*m_session), (std::vector<int>{0, 2, 3, 5}));
    QVERIFY(!m_session->hits().selected());
    QCOMPARE(m_table->currentIndex().row(), 1);
    m_session->undo();
    QCOMPARE(order(*m_session), (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

void HitHistoryTest::contextMenuActs() {
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, row(3).center());
    // The menu runs an event loop of its own.
    QTimer::singleShot(0, this, [] {
        QMenu* menu = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) != nullptr,
                                 kPatience);
        for (QAction* action : menu->actions()) {
            if (action->text() == QStringLiteral("Disable")) {
                // By key: Qt 6.8 passes over a click right after the menu has opened.
                menu->setActiveAction(action);
                QTest::keyClick(menu, Qt::Key_Return);
                return;
            }
        }
        menu->close();
    });
    QContextMenuEvent event(QContextMenuEvent::Mouse, row(3).center(),
                            m_table->viewport()->mapToGlobal(row(3).center()));
    QCoreApplication::sendEvent(m_table->viewport(), &event);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().disabled(), std::size_t{1}, kPatience);
    QVERIFY(!m_session->hits().history().hits()[3].enabled);
    QVERIFY(action(QStringLiteral("Disable")) == nullptr);
    action(QStringLiteral("Enable"))->trigger();
    QCOMPARE(m_session->hits().disabled(), std::size_t{0});
    action(QStringLiteral("Move Up"))->trigger();
    QCOMPARE(order(*m_session), (std::vector<int>{0, 1, 3, 2, 4, 5}));
    m_table->clearSelection();
    for (const char* text : {"Disable", "Move Up", "Move Down", "Remove", "Select All on This Target"}) {
        QVERIFY2(!action(QLatin1String(text))->isEnabled(), text);
    }
}

/// Through the window, where a drag that has begun takes its events from. Positions in the table's viewport.
void HitHistoryTest::drag(const QPoint& from, const QPoint& to) {
    QWindow* window = m_panel->windowHandle();
    const QWidget* viewport = m_table->viewport();
    const auto inWindow = [&](const QPoint& at) { return viewport->mapTo(m_panel.get(), at); };
    constexpr int kSteps = 8;
    int done = 0;
    // Each step asks for the next before it acts: one of them is where the drag's own event loop begins.
    std::function<void()> act = [&] {
        if (++done <= kSteps) {
            QTimer::singleShot(30, this, act);
            QTest::mouseMove(window,
                             inWindow(from + (to - from) * std::min(done, kSteps - 2) / (kSteps - 2)));
        } else {
            QTest::mouseRelease(window, Qt::LeftButton, {}, inWindow(to));
        }
    };
    QTest::mousePress(window, Qt::LeftButton, {}, inWindow(from));
    QTimer::singleShot(30, this, act);
    QTRY_VERIFY_WITH_TIMEOUT(done > kSteps, kPatience);
    QTest::qWait(200);
}

void HitHistoryTest::rowsAreDragged() {
    const QRect fourth = row(4);
    drag(row(1).center(), QPoint(fourth.center().x(), fourth.top() + 1));
    QCOMPARE(order(*m_session), (std::vector<int>{0, 2, 3, 1, 4, 5}));
    QCOMPARE(selected(), (std::vector<int>{3}));
    QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(3));
    m_session->undo();
    QCOMPARE(order(*m_session), (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

void HitHistoryTest::severalRowsAreDragged() {
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, row(5).center());
    QTest::mouseClick(m_table->viewport(), Qt::LeftButton, Qt::ControlModifier, row(3).center());
    drag(row(3).center(), QPoint(row(0).center().x(), row(0).top() + 1));
    QCOMPARE(order(*m_session), (std::vector<int>{3, 5, 0, 1, 2, 4}));
    QCOMPARE(selected(), (std::vector<int>{0, 1}));
    m_session->undo();
    QCOMPARE(order(*m_session), (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

void HitHistoryTest::selectionAndPlaceSurviveChanges() {
    addHits(*m_session, 500);
    m_table->selectRow(200);
    m_table->scrollTo(m_table->model()->index(200, 0), QAbstractItemView::PositionAtTop);
    const int place = m_table->verticalScrollBar()->value();
    m_session->hits().setEnabled(std::vector<std::size_t>{200, 300}, false);
    addHits(*m_session, 3);
    m_session->hits().remove(std::vector<std::size_t>{400, 450});
    m_session->hits().move(std::vector<std::size_t>{480}, 470);
    m_session->undo();
    QCoreApplication::processEvents();
    QCOMPARE(selected(), (std::vector<int>{200}));
    QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(200));
    QCOMPARE(m_table->verticalScrollBar()->value(), place);
    m_session->hits().remove(10);
    QCOMPARE(selected(), (std::vector<int>{199}));
    QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(199));
}

void HitHistoryTest::selectsAllOnTheTarget() {
    m_table->selectRow(1);
    action(QStringLiteral("Select All on This Target"))->trigger();
    QCOMPARE(selected(), (std::vector<int>{1, 5}));
}

void HitHistoryTest::filterListsManyTargetsAtOnce() {
    QTest::keyClick(m_table, Qt::Key_F, Qt::ControlModifier);
    auto* box = m_panel->findChild<QComboBox*>(QStringLiteral("filterTarget"));
    std::vector<TargetId> all;
    for (const std::unique_ptr<Target>& target : m_session->targets()) {
        all.push_back(target->id);
    }
    box->setCurrentIndex(3);
    QCOMPARE(m_table->model()->rowCount(), 1);
    QCoreApplication::processEvents();
    const QSignalSpy filled(box->model(), &QAbstractItemModel::rowsAboutToBeRemoved);
    m_session->targets().duplicate(all);
    QTRY_COMPARE_WITH_TIMEOUT(box->count(), 33, kPatience);
    QVERIFY2(filled.size() <= 2, qPrintable(QString::number(filled.size())));
    QCOMPARE(box->currentData().toUInt(), all[2].value);
    m_session->targets().remove({&all[2], 1});
    QTRY_COMPARE_WITH_TIMEOUT(box->currentIndex(), 0, kPatience);
    QCOMPARE(box->count(), 32);
}

void HitHistoryTest::summaryAndMeter() {
    const auto* summary = m_panel->findChild<QLabel*>(QStringLiteral("summary"));
    const auto* meter = m_panel->findChild<CapacityMeter*>();
    QCOMPARE(summary->text(), QStringLiteral("6 hits"));
    QVERIFY(!meter->isVisible());
    m_session->settings().setPipeline(PipelineKind::UniformArray);
    test::readBackOf(*m_session).setCapacity({10, false, 6, {}});
    QVERIFY(meter->isVisible());
    QCOMPARE(meter->text(), QStringLiteral("6 of 10 hits in the uniform array"));
    QVERIFY(!meter->isFull());
    m_session->hits().setEnabled(std::vector<std::size_t>{5}, false);
    test::readBackOf(*m_session).setCapacity({4, false, 4, {0}});
    QCOMPARE(summary->text(), QStringLiteral("6 hits, 1 disabled, 1 dropped"));
    QCOMPARE(meter->text(), QStringLiteral("4 of 4 hits in the uniform array"));
    QVERIFY(meter->isFull());
    QVERIFY(meter->toolTip().contains(QStringLiteral("Dropped so far: 1")));
    test::readBackOf(*m_session).setCapacity({4, true, 3, {}});
    QCOMPARE(meter->text(), QStringLiteral("3 of 4 hits on the fullest target"));
    QVERIFY(!meter->isFull());
    // Whose fault it is that there is room for so few.
    const QString driver = QStringLiteral("This graphics driver has room for no more.");
    QVERIFY(!meter->toolTip().contains(driver));
    CapacityReport fewer{4, false, 4, {}};
    fewer.byDriver = true;
    test::readBackOf(*m_session).setCapacity(fewer);
    QVERIFY(meter->toolTip().contains(driver));
    // Full, it is of another colour.
    const auto filled = [this] {
        auto* drawn = m_panel->findChild<CapacityMeter*>();
        return drawn->grab().toImage().pixelColor(4, drawn->height() / 2);
    };
    test::readBackOf(*m_session).setCapacity({4, false, 4, {}});
    const QColor full = filled();
    test::readBackOf(*m_session).setCapacity({4, false, 3, {}});
    QVERIFY(filled() != full);
    test::readBackOf(*m_session).setCapacity({});
    QVERIFY(!meter->isVisible());
}

void HitHistoryTest::hitsThatDoNothingAreGrey() {
    const auto picture = [this](int number) { return m_table->viewport()->grab(row(number)).toImage(); };
    const QImage disabledBefore = picture(1);
    const QImage droppedBefore = picture(2);
    const QImage otherBefore = picture(3);
    m_session->hits().setEnabled(std::vector<std::size_t>{1}, false);
    test::readBackOf(*m_session).setCapacity({4, false, 4, {2}});
    QVERIFY(picture(1) != disabledBefore);
    QVERIFY(picture(2) != droppedBefore);
    QVERIFY(picture(3) == otherBefore);
}

void HitHistoryTest::manyRowsAreHandledAtOnce() {
    addHits(*m_session, 20'000);
    m_table->selectAll();
    QTest::keyClick(m_table, Qt::Key_Space);
    QCOMPARE(m_session->hits().disabled(), std::size_t{20'006});
    m_session->undo();
    m_table->selectRow(0);
    action(QStringLiteral("Select All on This Target"))->trigger();
    QTest::keyClick(m_table, Qt::Key_Delete);
    QCOMPARE(m_session->hits().history().size(), std::size_t{15'004});
    m_session->undo();
    QCOMPARE(m_session->hits().history().size(), std::size_t{20'006});
}

HITSCOPE_TEST(HitHistoryTest, QApplication)

}  // namespace hitscope::hit_history_test

#include "hit_history_test.moc"
