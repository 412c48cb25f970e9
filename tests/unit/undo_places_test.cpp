// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::undo_places_test {

using namespace test;

namespace {

const Ray kShot{{-3, 0.1f, 0}, {1, 0, 0}};

/// Targets that are knocked about by hits.
class Knocked {
public:
    explicit Knocked(int balls = 1) {
        std::vector<TargetPlan> plans;
        for (int i = 0; i < balls; ++i) {
            plans.push_back(planMesh(makeHighPolySphere(0.5f)));
        }
        ScenePlan plan;
        plan.targets = std::move(plans);
        m_session.loadScene(std::move(plan));
    }

    Session& session() { return m_session; }
    const Target& ball(std::size_t index = 0) { return *m_session.targets()[index]; }
    glm::vec3 place(std::size_t index = 0) { return ball(index).transform.position; }

    bool makeDynamic(std::size_t index = 0) {
        TargetPhysics physics;
        physics.isDynamic = true;
        physics.mass = 5.0f;
        return m_session.targets().setPhysics(ball(index).id, physics).ok();
    }

    void rest() {
        for (int i = 0; i < 600 && m_session.simulation().isMoving(); ++i) {
            m_session.simulation().advance(0.1);
        }
    }

    /// A shot, with or without flight, and all that comes of it. Returns whether it struck.
    bool shoot(bool isInstant = true) {
        const std::size_t before = m_session.hits().history().size();
        const Ray ray{place() + glm::vec3(-3, 0.1f, 0), kShot.direction};
        if (isInstant) {
            (void)m_session.simulation().hitscan(ray);
        } else {
            m_session.simulation().shoot(ray);
        }
        m_session.simulation().advance(1.0 / 60.0);
        rest();
        return m_session.hits().history().size() == before + 1;
    }

private:
    Session m_session;
};

/// Metres.
float distance(const glm::vec3& one, const glm::vec3& other) {
    return glm::length(one - other);
}

}  // namespace

/// Where dynamic targets are after undo and redo.
class UndoPlacesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void shotsGiveBackThePlace_data() {
        QTest::addColumn<bool>("isInstant");
        QTest::newRow("instant") << true;
        QTest::newRow("in flight") << false;
    }
    void shotsGiveBackThePlace() {
        QFETCH(bool, isInstant);
        Knocked scene;
        Session& session = scene.session();
        QVERIFY(scene.makeDynamic());
        scene.rest();
        std::vector<glm::vec3> places{scene.place()};
        for (int shot = 0; shot < 3; ++shot) {
            QVERIFY(scene.shoot(isInstant));
            QVERIFY(distance(scene.place(), places.back()) > 0.1f);
            places.push_back(scene.place());
        }
        QSignalSpy moved(&session.targets(), &SessionTargets::changed);
        for (std::size_t left = 3; left-- > 0;) {
            session.undo();
            // A step of physics away at most: it was in the air, or had just been struck.
            QVERIFY(distance(scene.place(), places[left]) < 0.01f);
        }
        QCOMPARE(moved.count(), 3);
        scene.rest();
        QVERIFY(distance(scene.place(), places[0]) < 0.01f);
        for (std::size_t made = 1; made <= 3; ++made) {
            session.redo();
            QVERIFY(distance(scene.place(), places[made]) < 0.01f);
        }
        session.undo();
        session.undo();
        QVERIFY(distance(scene.place(), places[1]) < 0.01f);
    }

    void manyStepsAtOnce() {
        Knocked scene;
        Session& session = scene.session();
        QVERIFY(scene.makeDynamic());
        scene.rest();
        const glm::vec3 before = scene.place();
        const std::size_t done = session.steps().done();
        for (int shot = 0; shot < 5; ++shot) {
            QVERIFY(scene.shoot());
        }
        const glm::vec3 after = scene.place();
        session.goToStep(done);
        QVERIFY(distance(scene.place(), before) < 0.01f);
        session.goToStep(done + 5);
        QVERIFY(scene.place() == after);
        session.goToStep(done + 2);
        session.goToStep(done);
        QVERIFY(distance(scene.place(), before) < 0.01f);
    }

    /// Its dent reaches through it: in its shape of before the undo, it would be pushed off the floor.
    void platesStayOnTheFloor() {
        Session session;
        loadMesh(session, makeSheet(40, 40, 2.0f, 2.0f));
        const Target& plate = *session.targets().front();
        const glm::quat flat = glm::angleAxis(glm::radians(-90.0f), glm::vec3(1, 0, 0));
        QVERIFY(session.targets().setTransform(plate.id, {{0, -0.9f, 0}, flat}).ok());
        TargetPhysics physics;
        physics.isDynamic = true;
        QVERIFY(session.targets().setPhysics(plate.id, physics).ok());
        const auto rest = [&session] {
            for (int i = 0; i < 600 && session.simulation().isMoving(); ++i) {
                session.simulation().advance(1.0 / 60.0);
            }
        };
        rest();
        const glm::vec3 before = plate.transform.position;
        for (int shot = 0; shot < 3; ++shot) {
            QVERIFY(session.simulation().hitscan({{0.2f, 5, 0.1f}, {0, -1, 0}}));
            rest();
            session.undo();
            for (int i = 0; i < 30; ++i) {
                session.simulation().advance(1.0 / 60.0);
                QVERIFY2(distance(plate.transform.position, before) < 0.003f,
                         qPrintable(QString::number(distance(plate.transform.position, before))));
            }
            rest();
        }
    }

    /// What is not struck may be knocked over by what is.
    void othersGoBackToo() {
        Knocked scene(2);
        Session& session = scene.session();
        QVERIFY(scene.makeDynamic(0));
        QVERIFY(scene.makeDynamic(1));
        const glm::vec3 beside = scene.place(0) + glm::vec3(1.05f, 0, 0);
        QVERIFY(session.targets().setTransform(scene.ball(1).id, {beside, {1, 0, 0, 0}}).ok());
        scene.rest();
        const glm::vec3 before = scene.place(1);
        QVERIFY(scene.shoot(false));
        QVERIFY(distance(scene.place(1), before) > 0.1f);
        session.undo();
        QVERIFY(distance(scene.place(1), before) < 0.01f);
    }

    /// A hit on what stays where it is moves nothing, and neither does its undo.
    void hitsOnOthersMoveNothing() {
        Knocked scene(2);
        Session& session = scene.session();
        QVERIFY(scene.makeDynamic(1));
        scene.rest();
        QVERIFY(scene.shoot());
        QCOMPARE(session.hits().history().hits().back().target, scene.ball(0).id);
        const glm::vec3 knocked = scene.place(1) + glm::vec3(0, 0.5f, 0);
        QVERIFY(session.targets().setTransform(scene.ball(1).id, {knocked, {1, 0, 0, 0}}).ok());
        scene.rest();
        const glm::vec3 landed = scene.place(1);
        QVERIFY(distance(landed, knocked) > 0.1f);
        session.goToStep(session.steps().done() - 1);
        const glm::vec3 placed = scene.place(1);
        session.undo();
        QVERIFY(session.hits().history().size() == 0);
        QVERIFY(scene.place(1) == placed);
    }
};

HITSCOPE_TEST(UndoPlacesTest, QCoreApplication)

}  // namespace hitscope::undo_places_test

#include "undo_places_test.moc"
