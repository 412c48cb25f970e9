// SPDX-License-Identifier: GPL-3.0-or-later
// Targets are turned upright together, and set on the floor where their lowest vertex touches it.
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "mesh/primitives.h"
#include "session/session.h"
#include "session/stand_targets.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::stand_targets_test {

/// World, of its vertices as they are dented.
Bounds boundsOf(const Target& target) {
    Bounds bounds;
    for (const glm::vec3& position : target.deformed.positions()) {
        bounds.add(target.transform.position + target.transform.rotation * position);
    }
    return bounds;
}

bool isNear(float a, float b) {
    return std::abs(a - b) < 1.0e-4f;
}

class StandTargetsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        ScenePlan plan;
        for (const float x : {0.0f, 30.0f}) {
            MeshData mesh = makeLowPolyCube();
            for (glm::vec3& position : mesh.positions) {
                position = position * glm::vec3(1.0f, 0.5f, 2.0f) + glm::vec3(x, 1.0f, -2.0f);
            }
            plan.targets.push_back(planMesh(std::move(mesh)));
        }
        m_session->loadScene(std::move(plan));
    }
    void cleanup() { m_session.reset(); }

    void whatPointedAlongZPointsUp() {
        const Target& target = first();
        const Bounds before = boundsOf(target);
        const glm::quat rotation = target.transform.rotation;
        QVERIFY(turnUpright(*m_session, {&target.id, 1}).ok());
        const glm::quat turn = target.transform.rotation * glm::inverse(rotation);
        const glm::vec3 up = turn * glm::vec3(0.0f, 0.0f, 1.0f);
        QVERIFY(glm::distance(up, glm::vec3(0.0f, 1.0f, 0.0f)) < 1.0e-6f);
        const glm::vec3 side = turn * glm::vec3(1.0f, 0.0f, 0.0f);
        QVERIFY(glm::distance(side, glm::vec3(1.0f, 0.0f, 0.0f)) < 1.0e-6f);
        const Bounds after = boundsOf(target);
        QVERIFY(isNear(after.min.y, before.min.y));
        QVERIFY(isNear(after.size().y, before.size().z));
        QVERIFY(isNear(after.size().z, before.size().y));
        QVERIFY(isNear(after.centre().x, before.centre().x));
        QVERIFY(isNear(after.centre().z, before.centre().z));
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::RotateTarget, 1}));
        m_session->undo();
        QVERIFY(isNear(boundsOf(target).size().y, before.size().y));
    }

    /// As one object: parts of a file stay in their places to each other.
    void severalTurnTogether() {
        const glm::vec3 before =
            second().transform.rotation * second().deformed.positions()[0] + second().transform.position -
            (first().transform.rotation * first().deformed.positions()[0] + first().transform.position);
        const std::array ids{first().id, second().id, TargetId{77}};
        const float lowest = std::min(boundsOf(first()).min.y, boundsOf(second()).min.y);
        const std::size_t steps = m_session->steps().size();
        QVERIFY(turnUpright(*m_session, ids).ok());
        QCOMPARE(m_session->steps().size(), steps + 1);
        const glm::vec3 after =
            second().transform.rotation * second().deformed.positions()[0] + second().transform.position -
            (first().transform.rotation * first().deformed.positions()[0] + first().transform.position);
        QVERIFY(glm::distance(after, glm::vec3(before.x, before.z, -before.y)) < 1.0e-3f);
        QVERIFY(isNear(std::min(boundsOf(first()).min.y, boundsOf(second()).min.y), lowest));
    }

    void theLowestVertexStandsOnTheFloor() {
        const Target& target = first();
        RigidTransform tilted = target.transform;
        tilted.position += glm::vec3(3.0f, 40.0f, -7.0f);
        tilted.rotation = glm::angleAxis(0.4f, glm::normalize(glm::vec3(1.0f, 2.0f, 3.0f)));
        QVERIFY(m_session->targets().setTransform(target.id, tilted).ok());
        const std::array ids{first().id, second().id};
        QVERIFY(setOnFloor(*m_session, ids).ok());
        const float floor = m_session->targets().floorHeight();
        QVERIFY(isNear(boundsOf(first()).min.y, floor));
        QVERIFY(isNear(boundsOf(second()).min.y, floor));
        QVERIFY(first().transform.position.x == tilted.position.x);
        QVERIFY(first().transform.position.z == tilted.position.z);
        QVERIFY(glm::dot(first().transform.rotation, tilted.rotation) > 0.99999f);
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::MoveTarget, 1}));
    }

    /// Not of the original: a dent at the bottom must not leave a gap.
    void dentsCount() {
        const Target& target = first();
        const RenderMesh& render = target.deformed.render();
        std::vector<DynamicVertex> vertices(render.vertices.begin(), render.vertices.end());
        const float floor = m_session->targets().floorHeight();
        for (DynamicVertex& vertex : vertices) {
            vertex.position.y = std::max(vertex.position.y, 0.75f);
        }
        test::readBackOf(*m_session).take(target.id, 0, vertices);
        QVERIFY(boundsOf(target).min.y > floor + 0.01f);
        QVERIFY(setOnFloor(*m_session, {&target.id, 1}).ok());
        QVERIFY(isNear(boundsOf(target).min.y, floor));
    }

    void nothingIsDoneWhereNothingIsToDo() {
        const std::array ids{first().id, second().id};
        QVERIFY(setOnFloor(*m_session, ids).ok());
        const std::size_t steps = m_session->steps().size();
        QVERIFY(setOnFloor(*m_session, ids).ok());
        QVERIFY(turnUpright(*m_session, {}).ok());
        QCOMPARE(m_session->steps().size(), steps);
    }

private:
    [[nodiscard]] const Target& first() const { return *m_session->targets()[0]; }
    [[nodiscard]] const Target& second() const { return *m_session->targets()[1]; }

    std::unique_ptr<Session> m_session;
};

HITSCOPE_TEST(StandTargetsTest, QCoreApplication)

}  // namespace hitscope::stand_targets_test

#include "stand_targets_test.moc"
