// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <limits>

#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::physics_time_test {

using namespace test;

/// The world's clock, and how many projectiles there are at a time.
class PhysicsTimeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void pausedNothingMoves() {
        PhysicsWorld world;
        world.shoot({0, 0, 0}, {1, 0, 0}, {});
        QVERIFY(run(world, 0.1).empty());
        world.clock().setPaused(true);
        QVERIFY(world.clock().isPaused());
        const glm::vec3 before = world.projectiles().front().drawn;
        const double time = world.clock().time();
        QVERIFY(run(world, 1).empty());
        QVERIFY(world.projectiles().front().drawn == before);
        QCOMPARE(world.clock().time(), time);
        world.clock().setPaused(false);
        QVERIFY(run(world, 0.1).empty());
        QVERIFY(world.projectiles().front().position.x > before.x + 1.0f);
    }

    void oneStepIsOneStep() {
        PhysicsWorld world;
        world.clock().setPaused(true);
        world.shoot({0, 0, 0}, {1, 0, 0}, withSpeed(24));
        for (int i = 1; i <= 5; ++i) {
            QVERIFY(world.stepOnce().empty());
            const ProjectileState state = world.projectiles().front();
            QVERIFY(std::abs(state.position.x - 0.1f * static_cast<float>(i)) < 1e-5f);
            // What is drawn is what the step made.
            QVERIFY(glm::length(state.drawn - state.position) < 1e-5f);
        }
        QCOMPARE(std::lround(world.clock().time() * 240), 5L);
    }

    void slowMotionIsSlow() {
        PhysicsWorld world;
        world.clock().setTimeScale(0.1);
        world.shoot({0, 0, 0}, {1, 0, 0}, {});
        QVERIFY(run(world, 2).empty());
        QVERIFY(std::abs(world.clock().time() - 0.2) < 0.006);
        QVERIFY(std::abs(world.projectiles().front().position.x - 6.0f) < 0.2f);
        world.clock().setTimeScale(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(world.clock().timeScale(), 0.1);
        world.clock().setTimeScale(1e9);
        QCOMPARE(world.clock().timeScale(), timeScaleParameter().maximum);
    }

    /// Slow motion shows the same flight, not another one.
    void sameImpactAtAnyTimeScale() {
        std::vector<Impact> impacts;
        for (const double scale : {1.0, 0.1, 0.37, 3.0}) {
            PhysicsWorld world;
            world.clock().setTimeScale(scale);
            place(world, {1}, {{7, 0, 0}, {1, 0, 0, 0}}, sphereMesh(2, 40, 20));
            world.shoot({0, 0.3f, 0.2f}, {1, 0, 0}, {});
            const auto struck = run(world, 1.0 / scale);
            QCOMPARE(struck.size(), std::size_t{1});
            impacts.push_back(struck.front());
        }
        for (const Impact& impact : impacts) {
            QVERIFY(impact.point == impacts.front().point && impact.time == impacts.front().time);
        }
    }

    void partsOfAStepMakeTheSame() {
        constexpr int kProjectiles = 40;
        TargetPhysics dynamic;
        dynamic.isDynamic = true;
        const auto shootAll = [&dynamic](PhysicsWorld& world) {
            place(world, {1}, {{7, 0, 0}, {1, 0, 0, 0}}, sphereMesh(2, 40, 20));
            place(world, {2}, {{-7, 0, 0}, {1, 0, 0, 0}}, sphereMesh(2, 40, 20), dynamic);
            world.setFloor(-3);
            Random random(3);
            for (int i = 0; i < kProjectiles; ++i) {
                const float side = i % 2 == 0 ? 1.0f : -1.0f;
                ProjectileSettings shot;
                shot.bouncesCount = true;
                world.shoot({0, random.between(-1, 1), random.between(-1, 1)}, {side, 0, 0}, shot, 1);
            }
        };
        PhysicsWorld whole;
        PhysicsWorld parts;
        shootAll(whole);
        shootAll(parts);
        std::size_t struck = 0;
        for (int step = 0; step < 400; ++step) {
            const std::vector<Impact> expected = whole.takeStep();
            struck += expected.size();
            std::optional<std::vector<Impact>> impacts;
            std::size_t calls = 0;
            for (; !impacts && calls < 1000; ++calls) {
                impacts = parts.takeStep([] { return true; });
                QCOMPARE(parts.isMidStep(), !impacts);
            }
            QVERIFY(calls > parts.projectileCount());
            QVERIFY(impacts.has_value());
            QCOMPARE(impacts->size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                QVERIFY((*impacts)[i].point == expected[i].point &&
                        (*impacts)[i].impulse == expected[i].impulse &&
                        (*impacts)[i].projectile == expected[i].projectile);
            }
            const auto a = whole.projectiles();
            const auto b = parts.projectiles();
            QCOMPARE(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                QVERIFY(a[i].position == b[i].position && a[i].velocity == b[i].velocity);
            }
            QVERIFY(whole.dynamicTargets().front().transform.position ==
                    parts.dynamicTargets().front().transform.position);
        }
        QVERIFY2(struck > std::size_t{kProjectiles / 2}, qPrintable(QString::number(struck)));
    }

    /// Nothing is seen of half a step, and a change of the world comes after it.
    void aChangeFinishesTheStep() {
        PhysicsWorld world;
        place(world, {1}, {{1, 0, 0}, {1, 0, 0, 0}}, sheet(1));
        world.shoot({0.8f, 0, 0}, {1, 0, 0}, {}, 1);
        world.shoot({-5, 0, 0}, {1, 0, 0}, {}, 1);
        QVERIFY(!world.takeStep([] { return true; }));
        QVERIFY(world.isMidStep());
        QCOMPARE(world.projectiles().front().position.x, 0.8f);
        world.removeTarget({1});
        QVERIFY(world.isMidStep());  // its impacts are still to be had
        QVERIFY(world.projectiles().front().position.x != 0.8f);
        const auto impacts = world.takeStep([] { return true; });
        QVERIFY(impacts.has_value());
        QCOMPARE(impacts->size(), std::size_t{1});
        QVERIFY(!world.isMidStep());
        QCOMPARE(std::lround(world.clock().time() * 240), 1L);
    }

    void drawnBetweenTheSteps() {
        PhysicsWorld world;
        world.shoot({0, 0, 0}, {1, 0, 0}, withSpeed(24));
        // A step is 0.1 m here; frames of a fifth of a step must move on evenly.
        QVERIFY(world.advance(StepClock::kStep).empty());
        float last = world.projectiles().front().drawn.x;
        for (int i = 0; i < 40; ++i) {
            QVERIFY(world.advance(StepClock::kStep / 5).empty());
            const float x = world.projectiles().front().drawn.x;
            QVERIFY2(std::abs(x - last - 0.02f) < 1e-3f, qPrintable(QString("%1: %2").arg(i).arg(x - last)));
            last = x;
        }
    }

    void stepCanBeSet() {
        PhysicsWorld world;
        QCOMPARE(world.clock().step(), 1.0 / 240.0);
        QVERIFY(world.advance(0.1).empty());
        world.clock().setStep(0.001);
        const double before = world.clock().time();
        world.shoot({0, 0, 0}, {1, 0, 0}, withSpeed(10));
        QVERIFY(world.stepOnce().empty());
        QVERIFY(std::abs(world.clock().time() - before - 0.001) < 1e-12);
        QVERIFY(std::abs(world.projectiles().front().position.x - 0.01f) < 1e-6f);
        world.clock().setStep(5.0);
        QCOMPARE(world.clock().step(), stepParameter().maximum);
        world.clock().setStep(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(world.clock().step(), stepParameter().maximum);
    }

    void oldestGoesWhenThereAreTooMany() {
        PhysicsWorld world;
        ProjectileSettings settings;
        settings.mostAlive = 10;
        std::vector<ProjectileId> ids;
        for (int i = 0; i < 25; ++i) {
            ids.push_back(world.shoot({0, 3.0f * static_cast<float>(i), 0}, {1, 0, 0}, settings));
            QVERIFY(world.advance(0.01).empty());
        }
        const auto alive = world.projectiles();
        QCOMPARE(alive.size(), std::size_t{10});
        for (std::size_t i = 0; i < alive.size(); ++i) {
            QCOMPARE(alive[i].id.value, ids[15 + i].value);
        }
    }

    void twoThousandStayInTheWorld() {
        PhysicsWorld world;
        world.setFloor(0);
        place(world, {1}, {{0, 3, 0}, {1, 0, 0, 0}}, sphereMesh(3, 80, 40));
        ProjectileSettings settings;
        settings.mostAlive = 2000;
        settings.lifetime = 60;
        Random random(3);
        std::size_t hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 from = random.direction();
            const glm::vec3 origin = glm::vec3(0, 3, 0) + 8.0f * glm::vec3(from.x, std::abs(from.y), from.z);
            world.shoot(origin, glm::normalize(glm::vec3(0, 3, 0) - origin), settings);
            if (i % 20 == 0) {
                hits += run(world, 1.0 / 60.0).size();
            }
        }
        hits += run(world, 1).size();
        QCOMPARE(world.projectileCount(), std::size_t{2000});
        QVERIFY2(hits > 1500, qPrintable(QString::number(hits)));
        for (const ProjectileState& state : world.projectiles()) {
            QVERIFY(state.position.y > 0.0f);
            QVERIFY(glm::length(state.position - glm::vec3(0, 3, 0)) > 2.95f);
        }
    }

    void settingsHaveRanges() {
        const ProjectileSettings standard;
        for (std::size_t i = 0; i < projectileParameters().size(); ++i) {
            const ParameterDescriptor& parameter = projectileParameters()[i];
            QCOMPARE(static_cast<float>(parameterValue(standard, i)),
                     static_cast<float>(parameter.defaultValue));
            ProjectileSettings settings;
            setParameterValue(settings, i, parameter.maximum);
            QVERIFY(std::abs(parameterValue(settings, i) / parameter.maximum - 1.0) < 1e-6);
            setParameterValue(settings, i, 2.0 * parameter.maximum);
            QVERIFY(parameter.accepts(parameterValue(clamped(settings), i)));
        }
        QVERIFY(clamped(standard) == standard);
        const TargetPhysics target;
        for (std::size_t i = 0; i < targetParameters().size(); ++i) {
            const ParameterDescriptor& parameter = targetParameters()[i];
            QCOMPARE(static_cast<float>(parameterValue(target, i)),
                     static_cast<float>(parameter.defaultValue));
            TargetPhysics physics;
            setParameterValue(physics, i, std::numeric_limits<double>::quiet_NaN());
            QVERIFY(clamped(physics) == target);
        }
    }
};

HITSCOPE_TEST(PhysicsTimeTest, QCoreApplication)

}  // namespace hitscope::physics_time_test

#include "physics_time_test.moc"
