// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shots/shot_script.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::shot_script_test {

namespace {

const Ray kAxis{{1, 2, 3}, glm::normalize(glm::vec3(0.3f, -0.2f, -0.9f))};

float angle(const glm::vec3& a, const glm::vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::vector<Hit> hitsOf(const Session& session) {
    const std::span<const Hit> hits = session.hits().history().hits();
    return {hits.begin(), hits.end()};
}

/// A burst and a sweep at the paper's scene, played in frames of `frame` seconds.
std::vector<Hit> played(double frame, bool isInstant) {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    const glm::vec3 first = session.targets()[0]->transform.position;
    const glm::vec3 last = session.targets()[15]->transform.position;
    const glm::vec3 eye = first + glm::vec3(-9, 3, -9);
    ShotScript script;
    script.isInstant = isInstant;
    script.projectile.speed = 60.0f;
    script.shots = sweep({eye, glm::normalize(first - eye)}, {eye, glm::normalize(last - eye)}, 400, 0.0101);
    const auto more = burst({eye, glm::normalize(first - eye)}, 100, 0.1f, 5);
    script.shots.insert(script.shots.begin(), more.begin(), more.end());
    schedule(session, script);
    for (double t = 0.0; t < 6.0; t += frame) {
        session.simulation().advance(frame);
    }
    return hitsOf(session);
}

}  // namespace

/// Shots made by rule, and leaving at exact steps: the same on every run.
class ShotScriptTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void burstsAreTheSameAgain() {
        const auto shots = burst(kAxis, 500, 0.2f, 7);
        QCOMPARE(shots.size(), std::size_t{500});
        QVERIFY(burst(kAxis, 500, 0.2f, 7) == shots);
        QVERIFY(burst(kAxis, 500, 0.2f, 8) != shots);
        // Fewer of a seed are the first of more.
        const auto few = burst(kAxis, 20, 0.2f, 7);
        QVERIFY(std::equal(few.begin(), few.end(), shots.begin()));
        for (const TimedShot& shot : shots) {
            QCOMPARE(shot.time, 0.0);
            QVERIFY(shot.ray.origin == kAxis.origin);
            QVERIFY(std::abs(glm::length(shot.ray.direction) - 1.0f) < 1e-6f);
            QVERIFY(angle(shot.ray.direction, kAxis.direction) < 0.2f + 1e-4f);
        }
    }

    void burstsFillTheirConeEvenly() {
        // Half of the shots are within the cone of half the solid angle.
        const auto shots = burst(kAxis, 4000, 0.5f, 1);
        const float middle = std::acos(0.5f * (1.0f + std::cos(0.5f)));
        glm::vec3 sum(0.0f);
        int inner = 0;
        for (const TimedShot& shot : shots) {
            inner += angle(shot.ray.direction, kAxis.direction) < middle ? 1 : 0;
            sum += shot.ray.direction;
        }
        QVERIFY2(std::abs(inner - 2000) < 150, qPrintable(QString::number(inner)));
        QVERIFY(angle(sum, kAxis.direction) < 0.02f);
        // Nothing to spread over: all the same way; the whole sphere: every way.
        QVERIFY(angle(burst(kAxis, 1, 0.0f, 3).front().ray.direction, kAxis.direction) < 1e-4f);
        bool back = false;
        for (const TimedShot& shot : burst(kAxis, 50, glm::pi<float>(), 3)) {
            back = back || glm::dot(shot.ray.direction, kAxis.direction) < -0.5f;
        }
        QVERIFY(back);
    }

    void countsStayWithinBounds() {
        QVERIFY(burst(kAxis, -3, 0.1f, 1).empty());
        QVERIFY(sweep(kAxis, kAxis, 0, 0.1).empty());
        QCOMPARE(sweep(kAxis, kAxis, 1, 0.1).size(), std::size_t{1});
        QCOMPARE(burst(kAxis, 10'000'000, 0.1f, 1).size(), std::size_t{ShotScript::kMostShots});
    }

    void sweepsGoFromOneRayToTheOther() {
        const Ray other{{5, 2, 3}, glm::normalize(glm::vec3(-0.5f, 0, -1))};
        const auto shots = sweep(kAxis, other, 5, 0.1);
        QCOMPARE(shots.size(), std::size_t{5});
        for (std::size_t i = 0; i < shots.size(); ++i) {
            QCOMPARE(shots[i].time, static_cast<double>(i) * 0.1);
        }
        QVERIFY(shots.front().ray.origin == kAxis.origin && shots.back().ray.origin == other.origin);
        QVERIFY(angle(shots.front().ray.direction, kAxis.direction) < 1e-3f);
        QVERIFY(angle(shots.back().ray.direction, other.direction) < 1e-3f);
        QVERIFY(glm::length(shots[2].ray.origin - glm::vec3(3, 2, 3)) < 1e-6f);
    }

    void circlesGoAround() {
        const auto shots = circle({{0, 0, 0}, {0, 0, -1}}, {0, 1, 0}, 0.3f, 4, 0.5);
        QCOMPARE(shots.size(), std::size_t{4});
        const glm::vec3 wanted[] = {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}};
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::vec3 direction = wanted[i] * std::sin(0.3f) + glm::vec3(0, 0, -std::cos(0.3f));
            QVERIFY(glm::length(shots[i].ray.direction - direction) < 1e-6f);
            QCOMPARE(shots[i].time, 0.5 * static_cast<double>(i));
        }
    }

    void shotsLeaveAtTheirStep() {
        // Frames of any length: the 4th shot is on its way once 0.3 s are over, and not a step sooner.
        for (const double frame : {0.25, 1.0 / 60.0, 0.0037}) {
            Session session;
            ShotScript script;
            script.shots = sweep({{0, 50, 0}, {0, 1, 0}}, {{0, 50, 0}, {1, 0, 0}}, 10, 0.1);
            QSignalSpy changed(&session.simulation(), &Simulation::scheduleChanged);
            schedule(session, script);
            QCOMPARE(changed.count(), 1);
            QCOMPARE(session.simulation().shotsToCome(), std::size_t{10});
            QVERIFY(session.simulation().isMoving());
            const auto left = [&session] { return 10 - session.simulation().shotsToCome(); };
            double passed = 0.0;
            while (passed < 0.24) {
                session.simulation().advance(frame);
                passed += frame;
            }
            const auto steps = std::lround(session.simulation().physics().clock().time() * 240.0);
            // The first step is under way at step 0: shot k leaves before step 24 k.
            QCOMPARE(left(), static_cast<std::size_t>(1 + (steps - 1) / 24));
            while (session.simulation().physics().clock().time() < 0.3 - 1e-9) {
                session.simulation().stepOnce();
            }
            QCOMPARE(left(), std::size_t{3});
            session.simulation().stepOnce();
            QCOMPARE(left(), std::size_t{4});
            session.simulation().cancelScheduled();
            QCOMPARE(session.simulation().shotsToCome(), std::size_t{0});
        }
    }

    void sameHistoryOverThreeRuns_data() {
        QTest::addColumn<bool>("isInstant");
        QTest::newRow("flights") << false;
        QTest::newRow("instant shots") << true;
    }
    void sameHistoryOverThreeRuns() {
        QFETCH(bool, isInstant);
        const std::vector<Hit> first = played(1.0 / 60.0, isInstant);
        QVERIFY2(first.size() > 100, qPrintable(QString::number(first.size())));
        // Bit for bit: ==, over every field; and whatever the frames are.
        QVERIFY(played(1.0 / 60.0, isInstant) == first);
        QVERIFY(played(0.25, isInstant) == first);
        QVERIFY(played(0.0029, isInstant) == first);
    }

    void aVolleyDoesNotFlyApart() {
        // All at once from one point: each goes its own way as if it were alone.
        Session session;
        ShotScript script;
        script.shots = burst({{0, 100, 0}, {1, 0, 0}}, 200, 0.05f, 11);
        schedule(session, script);
        for (int i = 0; i < 24; ++i) {
            session.simulation().stepOnce();
        }
        const auto projectiles = session.simulation().physics().projectiles();
        QCOMPARE(projectiles.size(), std::size_t{200});
        const glm::vec3 fall(0, -9.81f * 0.1f, 0);
        for (std::size_t i = 0; i < projectiles.size(); ++i) {
            const glm::vec3 wanted = script.shots[i].ray.direction * script.projectile.speed + fall;
            QVERIFY(glm::length(projectiles[i].velocity - wanted) < 0.01f);
        }
    }

    void trailsAreWhereTheyHaveBeen() {
        Session session;
        session.simulation().shoot({{0, 100, 0}, {1, 0, 0}});
        for (int i = 0; i < 120; ++i) {
            session.simulation().stepOnce();
        }
        const ProjectileState state = session.simulation().physics().projectiles().front();
        QVERIFY(state.trail.size() >= 8);
        float last = state.position.x;
        for (auto point = state.trail.rbegin(); point != state.trail.rend(); ++point) {
            QVERIFY(point->x < last);
            last = point->x;
        }
        QVERIFY(std::abs(state.position.x - last - 30.0f * static_cast<float>(PhysicsWorld::kTrailSeconds)) <
                0.5f);
    }

    void predictionsComeTrue_data() {
        QTest::addColumn<bool>("isInstant");
        QTest::newRow("flights") << false;
        QTest::newRow("instant shots") << true;
    }
    void predictionsComeTrue() {
        QFETCH(bool, isInstant);
        Session session;
        loadMesh(session, makeHighPolySphere(2.5f));
        const Ray aside{{-8, 3, 1}, glm::normalize(glm::vec3(8, -1.0f, -0.5f))};
        const auto hit = session.simulation().predictedHit(aside, isInstant);
        QVERIFY(hit.has_value());
        QCOMPARE(session.hits().history().size(), std::size_t{0});
        QCOMPARE(session.simulation().physics().clock().time(), 0.0);
        if (isInstant) {
            QVERIFY(session.simulation().hitscan(aside));
        } else {
            session.simulation().shoot(aside);
            while (session.hits().history().size() == 0 && session.simulation().isMoving()) {
                session.simulation().stepOnce();
            }
        }
        const Hit& made = session.hits().history().hits().front();
        QVERIFY(glm::length(hit->point - made.point) < 1e-4f);
        QVERIFY(glm::length(hit->direction - made.direction) < 1e-4f);
        QVERIFY(std::abs(hit->time - made.time) < 1e-9);
        QVERIFY(std::abs(hit->impulse - made.impulse) < 0.02f * made.impulse);
        QCOMPARE(hit->target, made.target);
        QVERIFY(hit->constants == made.constants);
        QVERIFY(!session.simulation().predictedHit({{-8, 3, 1}, {-1, 0, 0}}, isInstant).has_value());
    }
};

HITSCOPE_TEST(ShotScriptTest, QCoreApplication)

}  // namespace hitscope::shot_script_test

#include "shot_script_test.moc"
