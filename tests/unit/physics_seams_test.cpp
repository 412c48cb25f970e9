// SPDX-License-Identifier: GPL-3.0-or-later
// How hard a projectile strikes that touches a target in several places.
#include <QTest>
#include <cmath>

#include "physics_support.h"
#include "support/test_program.h"

namespace hitscope::physics_seams_test {

using namespace test;

namespace {

constexpr RigidTransform kHere{};

}  // namespace

class PhysicsSeamsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// What the walls of a groove push sideways cancels out.
    void aGrooveGivesWhatTheProjectileLoses_data() {
        QTest::addColumn<float>("slope");
        QTest::newRow("flat") << 0.0f;
        QTest::newRow("shallow") << 0.5f;
        QTest::newRow("right angle") << 1.0f;
        QTest::newRow("steep") << 2.0f;
    }
    void aGrooveGivesWhatTheProjectileLoses() {
        QFETCH(float, slope);
        PhysicsWorld world;
        const Triangles groove{
            {{0, 0, -1}, {0, 0, 1}, {1, slope, -1}, {1, slope, 1}, {-1, slope, -1}, {-1, slope, 1}},
            {0, 1, 3, 0, 3, 2, 0, 5, 1, 0, 4, 5}};
        place(world, TargetId{1}, kHere, groove);
        ProjectileSettings shot;
        shot.gravity = 0.0f;
        const auto foreseen = world.predict({0, 3, 0.1f}, {0, -1, 0}, shot, false);
        world.shoot({0, 3, 0.1f}, {0, -1, 0}, shot);
        std::vector<Impact> impacts;
        for (int i = 0; i < 60 && impacts.empty(); ++i) {
            impacts = world.takeStep();
        }
        QCOMPARE(impacts.size(), std::size_t{1});
        const glm::vec3 after = world.projectiles().front().velocity;
        const float impulse = impacts.front().impulse;
        const float lost = shot.mass * glm::dot(after - glm::vec3(0, -shot.speed, 0), impacts.front().normal);
        QVERIFY2(std::abs(impulse - lost) < 0.01f * lost,
                 qPrintable(QStringLiteral("%1 for %2").arg(impulse).arg(lost)));
        if (slope <= 1.0f) {  // in a steeper one Bullet's solver does not come to an end
            QVERIFY2(std::abs(impulse - foreseen->impulse) < 0.01f * lost,
                     qPrintable(QStringLiteral("%1 for %2").arg(impulse).arg(foreseen->impulse)));
        }
    }
};

HITSCOPE_TEST(PhysicsSeamsTest, QCoreApplication)

}  // namespace hitscope::physics_seams_test

#include "physics_seams_test.moc"
