// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <map>

#include "deform/reference.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "physics_dents.h"
#include "session/paced_advance.h"
#include "session/session.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::physics_session_test {

using namespace test;

namespace {

/// Applies the session's hits as the reference pipeline does and hands back what changed.
class Follower {
public:
    explicit Follower(Session& session) : m_session(session) {}

    void follow() {
        const std::span<const Hit> hits = m_session.hits().history().hits();
        for (; m_applied < hits.size(); ++m_applied) {
            const Hit& hit = hits[m_applied];
            ReferenceDeformation& reference = of(hit.target);
            for (const VertexRange& range : reference.apply({&hit, 1})) {
                test::readBackOf(m_session).take(hit.target, range.first,
                                                 reference.vertices().subspan(range.first, range.count));
            }
        }
        test::readBackOf(m_session).finish();
    }

private:
    ReferenceDeformation& of(TargetId id) {
        auto& entry = m_references[id];
        if (!entry) {
            entry = std::make_unique<ReferenceDeformation>(m_session.targets().find(id)->deformed.render());
        }
        return *entry;
    }

    Session& m_session;
    std::map<TargetId, std::unique_ptr<ReferenceDeformation>> m_references;
    std::size_t m_applied = 0;
};

/// Metres, local frame; of the triangles that are on screen.
float distanceFromSurface(const Target& target, const glm::vec3& p) {
    const std::span<const DynamicVertex> vertices = target.deformed.vertices();
    const std::span<const std::uint32_t> corners = target.deformed.render().triangles;
    float least = 1e9f;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        least = std::min(least,
                         Dented::distance(p, vertices[corners[i]].position, vertices[corners[i + 1]].position,
                                          vertices[corners[i + 2]].position));
    }
    return least;
}

void play(Session& session, Follower& follower, double seconds) {
    for (double t = 0; t < seconds; t += 1.0 / 60.0) {
        session.simulation().advance(1.0 / 60.0);
        follower.follow();
    }
}

Ray towards(const glm::vec3& aim, const glm::vec3& from) {
    return {from, glm::normalize(aim - from)};
}

}  // namespace

/// Shots through the session: what is hit is what is on screen, and the same again on every run.
class PhysicsSessionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void hitsLieOnTheDeformedTeapot_data() {
        QTest::addColumn<bool>("instant");
        QTest::newRow("flights") << false;
        QTest::newRow("instant shots") << true;
    }
    void hitsLieOnTheDeformedTeapot() {
        QFETCH(bool, instant);
        Session session;
        loadTeapot(session);
        const Target& teapot = *session.targets().front();
        Follower follower(session);
        const Bounds bounds = teapot.worldBounds();
        Random random(41);
        std::size_t checked = 0;
        float farthest = 0.0f;
        for (int shot = 0; shot < 400 && checked < 130; ++shot) {
            const glm::vec3 from = bounds.centre() + bounds.diagonal() * random.direction();
            const glm::vec3 aim = bounds.centre() + 0.15f * bounds.diagonal() * random.direction();
            if (instant) {
                session.simulation().hitscan(towards(aim, from));
            } else {
                session.simulation().shoot(towards(aim, from));
                while (session.simulation().isMoving() && session.hits().history().size() == checked) {
                    session.simulation().advance(StepClock::kStep);
                }
            }
            // Before the hit itself dents what it struck.
            for (; checked < session.hits().history().size(); ++checked) {
                farthest = std::max(
                    farthest, distanceFromSurface(teapot, session.hits().history().hits()[checked].point));
            }
            follower.follow();
        }
        QVERIFY(checked >= 130);
        QVERIFY2(farthest < 0.001f, qPrintable(QString("%1 m").arg(farthest)));
        QVERIFY(teapot.deformed.statistics().maximum > 0.3);
    }

    void sameShotsMakeTheSameHistory() {
        const auto history = [](bool isReadBack) {
            Session session;
            loadPaperRow(session, kDefaultPaperRow);
            Follower follower(session);
            const TargetId knocked = session.targets()[3]->id;
            TargetPhysics physics;
            physics.isDynamic = true;
            if (!session.targets().setPhysics(knocked, physics)) {
                return std::vector<Hit>();
            }
            ProjectileSettings settings;
            settings.bouncesCount = true;
            session.settings().setProjectile(settings);
            Random random(77);
            for (int shot = 0; shot < 500; ++shot) {
                const auto index = static_cast<std::size_t>(random.between(0, 15.99f));
                const glm::vec3 aim = session.targets()[index]->transform.position + random.direction();
                session.simulation().shoot(towards(aim, aim + 6.0f * random.direction()));
                session.simulation().advance(1.0 / 60.0);
                if (isReadBack) {
                    follower.follow();
                }
            }
            play(session, follower, 1);
            const std::span<const Hit> hits = session.hits().history().hits();
            return std::vector<Hit>(hits.begin(), hits.end());
        };
        const std::vector<Hit> first = history(true);
        QVERIFY2(first.size() >= 400, qPrintable(QString::number(first.size())));
        // Bit for bit: ==, over every field.
        QVERIFY(history(true) == first);
        // Nor does it matter what a renderer makes of the hits, and when.
        QVERIFY(history(false) == first);
    }

    void recordSaysWhatWasStruck() {
        Session session;
        loadMesh(session, makeHighPolyCube());
        const Target& cube = *session.targets().front();
        QVERIFY(session.targets()
                    .setTransform(cube.id, {{5, 2, 1}, glm::angleAxis(1.5707963f, glm::vec3(0, 1, 0))})
                    .ok());
        QVERIFY(session.simulation().hitscan({{5, 2, 9}, {0, 0, -1}}));
        QVERIFY(!session.simulation().hitscan({{5, 2, 9}, {0, 0, 1}}));
        const Hit& hit = session.hits().history().hits().front();
        // What faces +z in the world is its -x side, turned.
        QVERIFY(glm::length(cube.transform.toWorld(hit.point) - glm::vec3(5, 2, 3.5f)) < 1e-4f);
        QVERIFY(glm::length(cube.transform.directionToWorld(hit.normal) - glm::vec3(0, 0, 1)) < 1e-5f);
        const RenderMesh& mesh = cube.deformed.render();
        QVERIFY(hit.triangle < mesh.triangles.size() / 3);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 corner = mesh.vertices[mesh.triangles[3 * hit.triangle + k]].position;
            QVERIFY(glm::length(corner - hit.point) < 0.3f);
        }
        QCOMPARE(session.hits().history().size(), std::size_t{1});
        session.undo();
        QVERIFY(session.hits().history().hits().empty());
    }

    void powerFollowsTheImpulseIfAsked() {
        Session session;
        loadMesh(session, makeLowPolyCube());
        const float power = session.settings().constants().power;
        ProjectileSettings settings;
        settings.speed = 60.0f;
        session.settings().setProjectile(settings);
        const Ray ray{{0, 0, 9}, {0, 0, -1}};
        QVERIFY(session.simulation().hitscan(ray));
        QCOMPARE(session.hits().history().hits().back().constants.power, power);
        settings.powerFollowsImpulse = true;
        session.settings().setProjectile(settings);
        session.hits().clear();  // its dent would be struck
        QVERIFY(session.simulation().hitscan(ray));
        // Twice the speed of the default shot.
        QVERIFY(std::abs(session.hits().history().hits().back().constants.power - 2.0f * power) < 1e-4f);
        settings.speed = 10000.0f;
        settings.mass = 1e6f;
        session.settings().setProjectile(settings);
        QVERIFY(session.simulation().hitscan(ray));
        QVERIFY(isValid(session.hits().history().hits().back().constants));
    }

    void pauseAndSingleStep() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        QSignalSpy changed(&session.simulation(), &Simulation::timeChanged);
        session.simulation().setPaused(true);
        session.simulation().setTimeScale(0.1);
        session.simulation().setStep(0.001);
        QCOMPARE(changed.count(), 3);
        session.simulation().shoot(towards(session.targets()[0]->transform.position, {0, 9, 0}));
        QVERIFY(!session.simulation().isMoving());
        session.simulation().advance(1);
        QCOMPARE(session.simulation().physics().clock().time(), 0.0);
        session.simulation().stepOnce();
        QVERIFY(std::abs(session.simulation().physics().clock().time() - 0.001) < 1e-12);
        session.simulation().setPaused(false);
        QVERIFY(session.simulation().isMoving());
    }

    void knockedAboutTargetTakesItsHitsAlong() {
        Session session;
        loadMesh(session, makeHighPolySphere(0.5f));
        const Target& ball = *session.targets().front();
        TargetPhysics physics;
        physics.isDynamic = true;
        physics.mass = 5.0f;
        QSignalSpy moved(&session.targets(), &SessionTargets::changed);
        QVERIFY(session.targets().setPhysics(ball.id, physics).ok());
        Follower follower(session);
        const glm::vec3 before = ball.transform.position;
        session.simulation().shoot({{-3, 0.1f, 0}, {1, 0, 0}});
        play(session, follower, 1);
        QCOMPARE(session.hits().history().size(), std::size_t{1});
        QVERIFY(ball.transform.position.x > before.x + 0.5f);
        QVERIFY(moved.count() > 10);
        const glm::vec3 point = session.hits().history().hits().front().point;
        QVERIFY(std::abs(glm::length(point) - 0.5f) < 1e-3f);
        // It can be made to stay where it is now, and that undone.
        QVERIFY(session.targets().setPhysics(ball.id, {}).ok());
        const glm::vec3 where = ball.transform.position;
        play(session, follower, 0.2);
        QVERIFY(ball.transform.position == where);
        session.undo();
        QVERIFY(ball.physics.isDynamic);
    }

    /// Its shape is brought up to date between steps, where somebody aims.
    void whatWakesIsTold() {
        Session session;
        loadMesh(session, makeHighPolySphere(0.5f));
        TargetPhysics physics;
        physics.isDynamic = true;
        QVERIFY(session.targets().setPhysics(session.targets().front()->id, physics).ok());
        QVERIFY(session.simulation().hitscan({{-3, 0.1f, 0}, {1, 0, 0}}));
        for (int i = 0; i < 600 && session.simulation().isMoving(); ++i) {
            session.simulation().advance(0.1);
        }
        QVERIFY(!session.simulation().isMoving());
        const std::size_t hit = 0;
        session.hits().setEnabled({&hit, 1}, false);
        for (int i = 0; i < 2; ++i) {
            QSignalSpy pictures(&session, &Session::pictureChanged);
            QVERIFY(session.simulation().updateColliders());
            QVERIFY(session.simulation().isMoving());
            QCOMPARE(pictures.count(), 1 - i);
        }
    }

    void hiddenAndShownAgainItHasItsDents() {
        Session session;
        loadMesh(session, makeHighPolySphere());
        const Target& ball = *session.targets().front();
        Follower follower(session);
        const Ray ray{{9, 0, 0}, {-1, 0, 0}};
        for (int i = 0; i < 5; ++i) {
            QVERIFY(session.simulation().hitscan(ray));
            follower.follow();
        }
        const float depth = session.hits().history().hits().back().point.x;
        QVERIFY(depth < 2.2f);
        const TargetId ids[] = {ball.id};
        session.targets().setVisible(ids, false);
        QVERIFY(!session.simulation().hitscan(ray));
        session.targets().setVisible(ids, true);
        QVERIFY(session.simulation().hitscan(ray));
        QVERIFY(session.hits().history().hits().back().point.x < depth);
        // Moved, too; and back at the original shape it is whole.
        QVERIFY(session.targets().setTransform(ball.id, {{0, 0, 1}, {1, 0, 0, 0}}).ok());
        QVERIFY(session.simulation().hitscan({{9, 0, 1}, {-1, 0, 0}}));
        QVERIFY(session.hits().history().hits().back().point.x < depth);
        session.hits().clear();
        QVERIFY(session.simulation().hitscan({{9, 0, 1}, {-1, 0, 0}}));
        QVERIFY(std::abs(session.hits().history().hits().back().point.x - 2.5f) < 0.01f);
    }

    void collidersTakeDentsOnInSlices() {
        Session atOnce;
        Session sliced;
        Random random(5);
        for (Session* session : {&atOnce, &sliced}) {
            loadMesh(*session, makeSheet(200, 200, 5.0f, 5.0f));
        }
        const std::span<const DynamicVertex> vertices = atOnce.targets().front()->deformed.vertices();
        std::vector<Hit> hits(100);
        for (Hit& hit : hits) {
            hit.target = atOnce.targets().front()->id;
            const auto at =
                static_cast<std::size_t>(random.between(0, static_cast<float>(vertices.size() - 1)));
            hit.point = vertices[at].position;
            hit.direction = -vertices[at].normal;
        }
        for (Session* session : {&atOnce, &sliced}) {
            for (Hit& hit : hits) {
                hit.target = session->targets().front()->id;
            }
            QVERIFY(session->hits().add(hits).ok());
        }
        QVERIFY(atOnce.simulation().updateColliders());
        int slices = 0;
        while (!sliced.simulation().updateColliders([] { return true; })) {
            ++slices;
        }
        QVERIFY2(slices >= 99, qPrintable(QString::number(slices)));
        for (int i = 0; i < 50; ++i) {
            const DynamicVertex& vertex = vertices[static_cast<std::size_t>(i) * vertices.size() / 50];
            const Ray ray{vertex.position + 5.0f * vertex.normal, -vertex.normal};
            for (Session* session : {&atOnce, &sliced}) {
                QVERIFY(session->simulation().hitscan(ray));
            }
            const Hit& a = atOnce.hits().history().hits().back();
            const Hit& b = sliced.hits().history().hits().back();
            QVERIFY(a.point == b.point && a.triangle == b.triangle && a.normal == b.normal);
        }
    }

    void slowStepsSlowTheSceneNotTheFrame() {
        Session session;
        loadTeapot(session);
        session.simulation().shoot({{0, 50, 9}, {0, 0, 1}});
        const auto stepsOf = [&session](double seconds, double perLook) {
            double now = 0.0;
            const double before = session.simulation().physics().clock().time();
            advanceWithin(session, seconds, 0.016, [&] { return now += perLook; });
            return std::lround((session.simulation().physics().clock().time() - before) / StepClock::kStep);
        };
        QCOMPARE(stepsOf(4 * StepClock::kStep, 0.0), 4L);
        QCOMPARE(stepsOf(0.25, 0.0), 60L);
        // A step with a projectile looks twice, and then at whether to begin another: 2, 4, 6; 8, 10, 12; 14,
        // 16 ms.
        QCOMPARE(stepsOf(0.25, 0.002), 2L);
        QCOMPARE(stepsOf(0.25, 0.0), 60L);  // that one among them
        int calls = 1;
        for (; stepsOf(0.25, 1.0) == 0; ++calls) {
            QVERIFY(calls < 3);
        }
        QCOMPARE(stepsOf(StepClock::kStep, 0.0), 1L);  // nothing to catch up with
        session.simulation().setTimeScale(0.1);
        QCOMPARE(stepsOf(20 * StepClock::kStep, 0.0), 2L);
    }

    void saysWhyATargetCannotBeHit() {
        Session session;
        MeshData line;
        line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
        line.faceStarts = {0, 3};
        line.cornerVertices = {0, 1, 2};
        loadMesh(session, line);
        QVERIFY(!session.simulation().whyNotHittable(session.targets().front()->id).isEmpty());
        QVERIFY(!session.simulation().hitscan({{0.5f, 5, 0}, {0, -1, 0}}));
        loadTeapot(session);
        QVERIFY(session.simulation().whyNotHittable(session.targets().front()->id).isEmpty());
    }
};

HITSCOPE_TEST(PhysicsSessionTest, QCoreApplication)

}  // namespace hitscope::physics_session_test

#include "physics_session_test.moc"
