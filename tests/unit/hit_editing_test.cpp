// SPDX-License-Identifier: GPL-3.0-or-later
// Changing selected hits, and what follows it.
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <memory>
#include <optional>

#include "analysis/hit_effects.h"
#include "analysis/hit_highlight.h"
#include "session/frame_costs.h"
#include "session/hit_editing.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"

namespace hitscope::hit_editing_test {

class HitEditingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_editing = std::make_unique<HitEditing>(*m_session);
        for (int i = 0; i < 4; ++i) {
            Hit hit;
            hit.target = m_session->targets().front()->id;
            hit.point = {0.4f * static_cast<float>(i), 0.0f, 2.5f};
            QVERIFY(m_session->hits().add(hit));
        }
    }
    void cleanup() {
        m_editing.reset();
        m_session.reset();
    }

    void aGestureIsOneStep() {
        m_session->hits().select(2);
        QCOMPARE(m_editing->rows().size(), std::size_t{1});
        for (const float reach : {0.6f, 0.7f, 0.8f}) {
            widen(reach);
            Q_EMIT m_session->frameCosts().frameEnded();
        }
        m_editing->endGesture();
        QCOMPARE(reachOf(2), 0.8f);
        widen(0.9f);
        m_editing->endGesture();
        m_session->undo();
        QCOMPARE(reachOf(2), 0.8f);
        m_session->undo();
        QCOMPARE(reachOf(2), 0.5f);
        QVERIFY(m_session->steps().toUndo()->kind == SessionUndo::Kind::Hit);
    }

    void oneEditAFrame() {
        m_session->hits().select(1);
        QSignalSpy changed(&m_session->hits(), &SessionHits::changed);
        for (int i = 0; i < 50; ++i) {
            widen(0.5f + 0.01f * static_cast<float>(i + 1));
        }
        QCOMPARE(changed.size(), 1);
        QCOMPARE(reachOf(1), 0.51f);
        Q_EMIT m_session->frameCosts().frameEnded();
        QCOMPARE(changed.size(), 2);
        QCOMPARE(reachOf(1), 1.0f);
        widen(1.2f);
        widen(1.3f);
        m_editing->endGesture();  // and nothing is lost
        QCOMPARE(reachOf(1), 1.3f);
    }

    /// What is not applied yet when a step is undone is of the history before.
    void undoTakesWhatWaitsForAFrame() {
        m_session->hits().select(1);
        widen(0.6f);
        widen(0.7f);
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = {0.0f, 0.4f, 2.5f};
        QVERIFY(m_session->hits().add(hit));
        m_session->undo();
        QVERIFY(m_session->steps().canRedo());
        QCOMPARE(reachOf(1), 0.6f);
        m_session->redo();
        QCOMPARE(m_session->hits().history().size(), std::size_t{5});
        Q_EMIT m_session->frameCosts().frameEnded();
        QCOMPARE(reachOf(1), 0.6f);
    }

    void aCancelledGestureLeavesNothing() {
        m_session->hits().select(1);
        widen(0.6f);
        widen(0.7f);
        m_editing->cancelGesture();
        QCOMPARE(reachOf(1), 0.5f);
        QVERIFY(m_session->steps().toUndo()->kind == SessionUndo::Kind::Hit);
    }

    void severalAreChangedTogether() {
        m_session->hits().select(3);
        m_editing->select({0, 1, 3});
        widen(0.6f);
        Q_EMIT m_session->frameCosts().frameEnded();
        widen(0.7f);
        m_editing->endGesture();
        QCOMPARE(reachOf(0), 0.7f);
        QCOMPARE(reachOf(1), 0.7f);
        QCOMPARE(reachOf(2), 0.5f);
        QCOMPARE(reachOf(3), 0.7f);
        QCOMPARE(m_session->steps().toUndo(),
                 (SessionUndo::Name{SessionUndo::Kind::EditHit, 3, 0, UndoPart::MaxDistance}));
        m_session->undo();
        QCOMPARE(reachOf(0), 0.5f);
        QCOMPARE(reachOf(3), 0.5f);
        // They stay selected where hits before them go.
        m_session->hits().remove(0);
        QVERIFY(std::equal(m_editing->rows().begin(), m_editing->rows().end(),
                           std::vector<std::size_t>{0, 2}.begin()));
    }

    /// Hits that stand together are replaced by one edit, which must not pass for other hits.
    void neighboursStaySelectedWhenTheyAreTurned() {
        m_session->hits().select(2);
        m_editing->select({1, 2, 3});
        const auto isSelected = [this] {
            return std::ranges::equal(m_editing->rows(), std::vector<std::size_t>{1, 2, 3}) &&
                   m_session->hits().selected() == std::optional<std::size_t>(2);
        };
        const Hit before = m_session->hits().history().hits()[2];
        const QSignalSpy rearranged(&m_session->hits(), &SessionHits::rearranged);
        for (const glm::vec3& direction : {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f)}) {
            turn(direction);
            Q_EMIT m_session->frameCosts().frameEnded();
            QVERIFY(isSelected());
            QCOMPARE(m_session->hits().history().hits()[3].direction, direction);
        }
        m_editing->endGesture();
        m_editing->change(2, [](Hit& hit) { hit.point.y = 0.5f; });
        m_editing->endGesture();
        QVERIFY(isSelected());
        QCOMPARE(m_session->hits().history().hits()[1].point.y, 0.5f);
        QCOMPARE(m_session->steps().toUndo(),
                 (SessionUndo::Name{SessionUndo::Kind::EditHit, 3, 0, UndoPart::Point}));
        m_session->undo();
        QVERIFY(isSelected());
        QCOMPARE(m_session->hits().history().hits()[2].direction, glm::vec3(0.0f, 1.0f, 0.0f));
        m_session->undo();
        QVERIFY(isSelected());
        QVERIFY(m_session->hits().history().hits()[2] == before);
        m_session->redo();
        QVERIFY(isSelected());
        turn({1.0f, 0.0f, 0.0f});
        m_editing->cancelGesture();
        QVERIFY(isSelected());
        QCOMPARE(rearranged.size(), 0);
    }

    void neighboursStaySelectedWhenTheirMeshIsAnother() {
        m_session->hits().select(2);
        m_editing->select({1, 2, 3});
        const TargetState state = *m_session->targets().front();
        const auto ids = m_session->targets().replaceMeshes({&state, 1}, [](Hit hit) {
            hit.point.y += 0.1f;
            hit.triangle = kNoIndex;
            return hit;
        });
        const std::vector<std::size_t> rows{1, 2, 3};
        QVERIFY(m_session->hits().history().hits()[2].target == ids.at(state.id));
        QVERIFY(std::ranges::equal(m_editing->rows(), rows));
        m_session->undo();
        QVERIFY(m_session->hits().history().hits()[2].target == state.id);
        QVERIFY(std::ranges::equal(m_editing->rows(), rows));
        QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(2));
    }

    void aNewSceneForgetsThem() {
        m_session->hits().select(3);
        widen(0.6f);
        widen(0.7f);  // not done yet
        loadTeapot(*m_session);
        QVERIFY(m_editing->rows().empty());
        QCOMPARE(m_editing->current(), nullptr);
        // What was not done yet is not done by the way.
        QVERIFY(m_session->steps().toUndo()->kind == SessionUndo::Kind::LoadScene);
        m_session->undo();
        QCOMPARE(reachOf(3), 0.6f);
    }

    void whatIsEditedIsShown() {
        m_session->hits().select(3);
        m_session->hits().show(2);
        widen(0.6f);
        QVERIFY(m_session->hits().showsAll());
    }

    void whatIsRefusedStays() {
        m_session->hits().select(0);
        const QSignalSpy refused(m_editing.get(), &HitEditing::refused);
        m_editing->change(0, [](Hit& hit) { hit.direction = glm::vec3(0.0f); });
        m_editing->endGesture();
        QCOMPARE(refused.size(), 1);
        QCOMPARE(m_session->hits().history().hits()[0].direction, glm::vec3(0.0f, 0.0f, -1.0f));
    }

    void litVerticesFollowTheEdit() {
        HitEffects effects(*m_session);
        const HitHighlight highlight(*m_session, effects);
        VertexSelection& selection = m_session->selection();
        m_session->hits().select(1);
        effects.finish();
        const std::size_t before = selection.count();
        QVERIFY(before > 0);
        widen(1.2f);
        m_editing->endGesture();
        effects.finish();
        const std::size_t wide = selection.count();
        QVERIFY2(wide > before, qPrintable(QStringLiteral("%1 of %2").arg(wide).arg(before)));
        m_session->undo();
        effects.finish();
        QCOMPARE(selection.count(), before);
        // What a person selects meanwhile is left alone.
        selection.select(m_session->targets().front()->id, {7}, VertexSelection::Combine::Replace);
        widen(1.2f);
        m_editing->endGesture();
        effects.finish();
        QCOMPARE(selection.count(), std::size_t{1});
    }

private:
    void widen(float reach) {
        m_editing->change(0, [reach](Hit& hit) { hit.constants.maxDistance = reach; });
    }
    void turn(const glm::vec3& direction) {
        m_editing->change(1, [direction](Hit& hit) {
            hit.flight = hit.flight != glm::vec3(0.0f) ? hit.flight : hit.direction;
            hit.direction = direction;
        });
    }
    float reachOf(std::size_t hit) const {
        return m_session->hits().history().hits()[hit].constants.maxDistance;
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<HitEditing> m_editing;
};

HITSCOPE_TEST(HitEditingTest, QCoreApplication)

}  // namespace hitscope::hit_editing_test

#include "hit_editing_test.moc"
