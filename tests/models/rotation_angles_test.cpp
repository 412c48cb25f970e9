// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/rotation_angles.h"
#include "support/test_program.h"

#include <QTest>
#include <cmath>

namespace hitscope::rotation_angles_test {

namespace {

const glm::dvec3 kNotThese(1.5, 2.5, 3.5);

bool near(const glm::dvec3& a, const glm::dvec3& b, double off = 1.0e-3) {
    return std::abs(a.x - b.x) < off && std::abs(a.y - b.y) < off && std::abs(a.z - b.z) < off;
}

double sum(const glm::dvec3& angles) {
    return std::abs(angles.x) + std::abs(angles.y) + std::abs(angles.z);
}

}  // namespace

class RotationAnglesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void oneAxisTurnsTheRightWay() {
        // Right-handed: about y, +z comes to +x.
        const glm::vec3 turned = fromAngles({0, 90, 0}) * glm::vec3(0, 0, 1);
        QVERIFY(glm::distance(turned, glm::vec3(1, 0, 0)) < 1.0e-6f);
        // About x first, z last.
        const glm::vec3 order = fromAngles({90, 0, 90}) * glm::vec3(0, 1, 0);
        QVERIFY(glm::distance(order, glm::vec3(0, 0, 1)) < 1.0e-6f);
    }
    void comeBack() {
        for (int x = -170; x <= 175; x += 30) {
            for (int y = -85; y <= 85; y += 17) {
                for (int z = -170; z <= 175; z += 30) {
                    const glm::dvec3 angles(x, y, z);
                    const glm::dvec3 found = toAngles(fromAngles(angles), kNotThese);
                    const bool isOther = sum(found) < sum(angles) - 0.01;
                    QVERIFY(near(found, angles, 0.01) || isOther);
                    QVERIFY(std::abs(glm::dot(fromAngles(found), fromAngles(angles))) > 0.999999f);
                }
            }
        }
    }
    void aTurnAboutOneAxisReadsAsOne() {
        for (const double angle : {131.9, -131.9, 179.0, -95.0}) {
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 angles(0.0);
                angles[axis] = angle;
                QVERIFY(near(toAngles(fromAngles(angles), kNotThese), angles, 0.01));
            }
        }
    }
    void straightUpGivesTheSameRotation() {
        for (const double y : {90.0, -90.0}) {
            const glm::quat rotation = fromAngles({30, y, 70});
            const glm::quat again = fromAngles(toAngles(rotation, kNotThese));
            QVERIFY(std::abs(glm::dot(rotation, again)) > 0.999999f);
        }
    }
    void shownNumbersStayWhereTheyMeanTheSame() {
        const glm::dvec3 shown(200, 100, -350);
        QCOMPARE(toAngles(fromAngles(shown), shown), shown);
        QCOMPARE(toAngles(-fromAngles(shown), shown), shown);
        QVERIFY(toAngles(fromAngles({200, 100.01, -350}), shown) != shown);
    }
};

HITSCOPE_TEST(RotationAnglesTest, QCoreApplication)

}  // namespace hitscope::rotation_angles_test

#include "rotation_angles_test.moc"
