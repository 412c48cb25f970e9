// SPDX-License-Identifier: GPL-3.0-or-later
// Scaling a target: it stands where it stood, its hits go along, and its file's coordinates stay.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "deform/deform.h"
#include "mesh/primitives.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/mesh_steps/scale_target.h"
#include "session/session.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"

namespace hitscope::scale_target_test {

class ScaleTargetTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        MeshData mesh = makeLowPolyCube();
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            mesh.positions[v] += glm::vec3(30.0f, 1.0f, -2.0f);
        }
        ScenePlan plan;
        plan.targets.push_back(planMesh(makeLowPolyCube()));
        plan.targets.push_back(planMesh(std::move(mesh)));
        m_session->loadScene(std::move(plan));
    }
    void cleanup() { m_session.reset(); }

    void itStandsWhereItStood_data() {
        QTest::addColumn<double>("times");
        QTest::newRow("smaller") << 0.01;
        QTest::newRow("as it is") << 1.0;
        QTest::newRow("larger") << 250.0;
    }
    void itStandsWhereItStood() {
        QFETCH(const double, times);
        const TargetState before = *m_session->targets()[1];
        const Bounds old = m_session->targets()[1]->worldBounds();
        const auto extent = static_cast<double>(m_session->targets()[1]->extent());
        const std::size_t steps = m_session->steps().size();
        const Result<ScaledTarget> scaled = scaledTo(before, times * extent);
        QVERIFY(scaled.ok());
        QVERIFY(std::abs(static_cast<double>(scaled.value().factor) / times - 1.0) < 1.0e-6);
        QVERIFY(takeScaled(*m_session, scaled.value()).ok());
        const Target& after = *m_session->targets()[1];
        QCOMPARE(after.name, before.name);
        QVERIFY(after.transform == before.transform);
        const Bounds now = after.worldBounds();
        QVERIFY(std::abs(static_cast<double>(after.extent()) / (times * extent) - 1.0) < 1.0e-5);
        const float tiny = 1.0e-5f * std::max(after.extent(), 1.0f);
        QVERIFY(std::abs(now.min.y - old.min.y) < tiny);
        QVERIFY(std::abs(now.centre().x - old.centre().x) < tiny);
        QVERIFY(std::abs(now.centre().z - old.centre().z) < tiny);
        // What an export writes.
        const MeshData& mesh = after.deformed.original();
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            QVERIFY(glm::vec3(mesh.filePositions[v]) == before.shape.mesh->positions[v]);
            const glm::vec3 back(mesh.placement.toFile(glm::dvec3(mesh.positions[v])));
            QVERIFY(glm::distance(back, before.shape.mesh->positions[v]) <
                    1.0e-5f / std::min(1.0f, static_cast<float>(times)));
        }
        QCOMPARE(m_session->steps().size(), steps + 1);
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::ScaleTarget, 1}));
        QCOMPARE(m_session->steps().target(steps), before.name);
        m_session->undo();
        QVERIFY(m_session->targets()[1]->shape.mesh == before.shape.mesh);
    }

    /// What no face uses neither counts nor is stood on.
    void looseVerticesDoNotCount() {
        MeshData mesh = makeLowPolyCube();
        mesh.positions.push_back({100.0f, -50.0f, 0.0f});
        ScenePlan plan;
        plan.targets.push_back(planMesh(std::move(mesh)));
        m_session->loadScene(std::move(plan));
        const Bounds old = m_session->targets()[0]->worldBounds();
        const auto extent = static_cast<double>(m_session->targets()[0]->extent());
        const Result<ScaledTarget> scaled = scaledTo(*m_session->targets()[0], 2.0 * extent);
        QVERIFY(scaled.ok());
        QCOMPARE(scaled.value().factor, 2.0f);
        QVERIFY(takeScaled(*m_session, scaled.value()).ok());
        const Bounds now = m_session->targets()[0]->worldBounds();
        QVERIFY(std::abs(static_cast<double>(m_session->targets()[0]->extent()) / extent - 2.0) < 1.0e-5);
        QVERIFY(std::abs(now.min.y - old.min.y) < 1.0e-4f);
        QVERIFY(std::abs(now.centre().x - old.centre().x) < 1.0e-4f);
    }

    /// On its side, it stands on that.
    void aTurnedOneStandsWhereItStood() {
        const Target& target = *m_session->targets()[1];
        const RigidTransform lying{{1.0f, 2.0f, 3.0f}, glm::angleAxis(1.1f, glm::vec3(0.6f, 0.0f, 0.8f))};
        QVERIFY(m_session->targets().setTransform(target.id, lying).ok());
        const Bounds old = seenBounds(target);
        const Result<ScaledTarget> scaled = scaledTo(target, 3.0 * static_cast<double>(target.extent()));
        QVERIFY(scaled.ok());
        m_session->selection().select(target.id, {5}, VertexSelection::Combine::Replace);
        QVERIFY(takeScaled(*m_session, scaled.value()).ok());
        const Target& after = *m_session->targets()[1];
        const Bounds now = seenBounds(after);
        QVERIFY(std::abs(now.min.y - old.min.y) < 1.0e-3f);
        QVERIFY(std::abs(now.centre().x - old.centre().x) < 1.0e-3f);
        QVERIFY(std::abs(now.centre().z - old.centre().z) < 1.0e-3f);
        QVERIFY(std::abs(now.size().y / old.size().y - 3.0f) < 1.0e-3f);
        QCOMPARE(m_session->selection().vertices(after.id).size(), std::size_t{1});
    }

    /// As dents of a mesh that was read in that size.
    void itsHitsGoAlong() {
        const Target& target = *m_session->targets()[1];
        const Target& other = *m_session->targets()[0];
        hitFromAbove(target);
        hitFromAbove(other);
        const Hit before = hits()[0];
        const Hit others = hits()[1];
        const float deepest = deepestOn(target);
        QVERIFY(deepest > 0.01f);
        const Result<ScaledTarget> scaled = scaledTo(target, 0.1 * static_cast<double>(target.extent()));
        QVERIFY(scaled.ok());
        QVERIFY(takeScaled(*m_session, scaled.value()).ok());
        QCOMPARE(hits().size(), std::size_t{2});
        const Target& after = *m_session->targets()[1];
        QVERIFY(hits()[0].target == after.id);
        QVERIFY(hits()[1] == others);
        QVERIFY(std::abs(hits()[0].constants.maxDistance / before.constants.maxDistance - 0.1f) < 1.0e-6f);
        QVERIFY(std::abs(hits()[0].constants.power / before.constants.power - 0.01f) < 1.0e-6f);
        const float now = deepestOn(after);
        QVERIFY2(std::abs(now / deepest - 0.1f) < 1.0e-4f, qPrintable(QString::number(now / deepest)));
        m_session->undo();
        QVERIFY(hits()[0] == before);
        m_session->redo();
        QVERIFY(std::abs(hits()[0].constants.power / before.constants.power - 0.01f) < 1.0e-6f);
    }

    void whatCannotBeScaledIsRefused() {
        const Target& target = *m_session->targets()[1];
        for (const double extent :
             {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            QVERIFY(!scaledTo(target, extent).ok());
        }
        Result<EditedMesh> refined =
            edited(*target.shape.mesh,
                   meshEdit(*m_session, target.id, RefineOptions{.edgeLength = 0.5f, .region = {}}));
        QVERIFY(refined.ok());
        QVERIFY(!scaledTo(stateWith(target, std::move(refined).value()), 1.0).ok());
    }

private:
    static Bounds seenBounds(const Target& target) {
        Bounds bounds;
        for (const glm::vec3& position : target.deformed.positions()) {
            bounds.add(target.transform.toWorld(position));
        }
        return bounds;
    }
    std::span<const Hit> hits() const { return m_session->hits().history().hits(); }
    void hitFromAbove(const Target& target) {
        const Bounds bounds = target.worldBounds();
        const glm::vec3 above = bounds.centre() + glm::vec3(0.1f, 10.0f, 0.2f);
        QVERIFY(m_session->simulation().hitscan({above, {0.0f, -1.0f, 0.0f}}));
    }
    /// Metres: how far the reference moves a vertex at most.
    float deepestOn(const Target& target) const {
        float deepest = 0.0f;
        for (const glm::vec3& original : target.deformed.original().positions) {
            glm::vec3 position = original;
            for (const Hit& hit : hits()) {
                if (hit.target == target.id) {
                    glm::vec3 normal(0.0f, 1.0f, 0.0f);
                    deform(position, normal, hit);
                }
            }
            deepest = std::max(deepest, glm::distance(position, original));
        }
        return deepest;
    }

    std::unique_ptr<Session> m_session;
};

HITSCOPE_TEST(ScaleTargetTest, QCoreApplication)

}  // namespace hitscope::scale_target_test

#include "scale_target_test.moc"
