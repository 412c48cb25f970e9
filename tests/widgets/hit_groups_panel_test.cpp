// SPDX-License-Identifier: GPL-3.0-or-later
// Hits that belong together, in the hit history's panel: grouped by its menu, then chosen, disabled and
// removed as one.
#include <QAction>
#include <QApplication>
#include <QTableView>
#include <QTest>

#include "panels/hit_history/hit_history_panel.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::hit_groups_panel_test {

class HitGroupsPanelTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private:
    [[nodiscard]] std::span<const Hit> hits() const { return m_session->hits().history().hits(); }
    void click(int row, Qt::KeyboardModifiers modifiers = {}) const {
        const QRect cell = m_table->visualRect(m_table->model()->index(row, HitHistoryModel::TargetColumn));
        QTest::mouseClick(m_table->viewport(), Qt::LeftButton, modifiers, cell.center());
    }
    [[nodiscard]] QAction* action(const char* name) const {
        return m_panel->findChild<QAction*>(QLatin1String(name));
    }
    [[nodiscard]] QString groupOf(int row) const {
        return m_table->model()->index(row, HitHistoryModel::GroupColumn).data().toString();
    }
    [[nodiscard]] qsizetype selected() const { return m_table->selectionModel()->selectedRows().size(); }

    std::unique_ptr<TestSettings> m_settings;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<HitEffects> m_effects;
    std::unique_ptr<HitHistoryModel> m_model;
    std::unique_ptr<HitHistoryPanel> m_panel;
    QTableView* m_table = nullptr;

private Q_SLOTS:
    void init() {
        m_settings = std::make_unique<TestSettings>();
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_effects = std::make_unique<HitEffects>(*m_session);
        m_model = std::make_unique<HitHistoryModel>(*m_session, m_effects.get());
        m_panel = std::make_unique<HitHistoryPanel>(*m_session, *m_model);
        m_table = m_panel->findChild<QTableView*>();
        m_panel->resize(900, 400);
        m_panel->show();
        makeActive(*m_panel);
        for (int i = 0; i < 6; ++i) {
            Hit hit;
            hit.target = m_session->targets()[0]->id;
            hit.point = {0.1f * static_cast<float>(i), 0.0f, 2.5f};
            QVERIFY(m_session->hits().add(hit).ok());
        }
        m_table->setFocus();
    }
    void cleanup() {
        m_panel.reset();
        m_model.reset();
        m_effects.reset();
        m_session.reset();
        m_settings.reset();
    }

    void selectedHitsBecomeAGroup() {
        click(1);
        QVERIFY(!action("groupHits")->isEnabled());  // one alone is none
        QVERIFY(!action("selectGroup")->isEnabled());
        QVERIFY(!action("ungroupHits")->isEnabled());
        click(3, Qt::ControlModifier);
        click(4, Qt::ControlModifier);
        QVERIFY(action("groupHits")->isEnabled());
        action("groupHits")->trigger();
        const HitGroup group = hits()[1].group;
        QVERIFY(group);
        for (const std::size_t hit : {3, 4}) {
            QVERIFY(hits()[hit].group == group);
        }
        for (const std::size_t hit : {0, 2, 5}) {
            QVERIFY(!hits()[hit].group);
        }
        QVERIFY(!groupOf(1).isEmpty());
        QCOMPARE(groupOf(4), groupOf(1));
        QVERIFY(groupOf(0).isEmpty());

        click(4);
        QCOMPARE(selected(), qsizetype{1});
        action("selectGroup")->trigger();
        QCOMPARE(selected(), qsizetype{3});
        QTest::keyClick(m_table, Qt::Key_Space);
        for (std::size_t hit = 0; hit < hits().size(); ++hit) {
            QCOMPARE(hits()[hit].enabled, !(hit == 1 || hit == 3 || hit == 4));
        }
        m_session->undo();
        QVERIFY(std::ranges::all_of(hits(), &Hit::enabled));  // in one step

        action("ungroupHits")->trigger();
        QVERIFY(std::ranges::none_of(hits(), [](const Hit& hit) { return static_cast<bool>(hit.group); }));
        QVERIFY(groupOf(1).isEmpty());
        m_session->undo();
        QVERIFY(hits()[1].group == group);
        m_session->undo();
        QVERIFY(!hits()[1].group);
    }

    void aGroupIsRemovedAsOne() {
        click(0);
        click(2, Qt::ShiftModifier);
        action("groupHits")->trigger();
        click(1);
        action("selectGroup")->trigger();
        QTest::keyClick(m_table, Qt::Key_Delete);
        QCOMPARE(hits().size(), std::size_t{3});
        m_session->undo();
        QCOMPARE(hits().size(), std::size_t{6});
        QVERIFY(hits()[2].group);
    }
};

HITSCOPE_TEST(HitGroupsPanelTest, QApplication)

}  // namespace hitscope::hit_groups_panel_test

#include "hit_groups_panel_test.moc"
