// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cstring>
#include <functional>
#include <limits>

#include "deform/hit.h"
#include "deform_support.h"
#include "support/test_program.h"

namespace hitscope::deform_hit_test {

using Damage = std::function<void(Hit&)>;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

class HitTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void constantsHaveThePapersDefaults() {
        const DeformationConstants defaults;
        const char* const keys[] = {"max_distance", "power", "max_magnitude"};
        for (std::size_t i = 0; i < 3; ++i) {
            const ParameterDescriptor& parameter = deformationParameters()[i];
            QCOMPARE(std::string(parameter.key), std::string(keys[i]));
            QCOMPARE(float(parameter.defaultValue), float(parameterValue(defaults, i)));
            for (const double value :
                 {parameter.minimum, parameter.maximum, parameter.minimum + parameter.step}) {
                DeformationConstants constants;
                setParameterValue(constants, i, value);
                QCOMPARE(float(parameterValue(constants, i)), float(value));
                QVERIFY(isValid(constants));
            }
            for (const double value : {parameter.minimum - 0.0005, parameter.maximum + 1.0, double{kNan}}) {
                DeformationConstants constants;
                setParameterValue(constants, i, value);
                QVERIFY(!isValid(constants));
            }
        }
        QCOMPARE(deformationParameters()[kPower].defaultValue, 0.05);  // not the float's 0.05000000075
        QCOMPARE(defaults.maxDistance, 0.5f);
        QCOMPARE(defaults.power, 0.05f);
        QCOMPARE(defaults.maxMagnitude, 0.3f);
    }

    void badHitsAreRefused_data() {
        QTest::addColumn<Damage>("damage");
        QTest::addColumn<QString>("where");
        const auto row = [](const char* name, const char* where, Damage damage) {
            QTest::newRow(name) << std::move(damage) << QString(where);
        };
        row("point nan", "hit point", [](Hit& h) { h.point.y = kNan; });
        row("point infinite", "hit point", [](Hit& h) { h.point.z = -kInfinity; });
        row("direction nan", "hit direction", [](Hit& h) { h.direction.x = kNan; });
        row("direction infinite", "hit direction", [](Hit& h) { h.direction.x = kInfinity; });
        row("no direction", "hit direction", [](Hit& h) { h.direction = glm::vec3(0.0f); });
        row("minus zero", "hit direction", [](Hit& h) { h.direction = glm::vec3(-0.0f); });
        row("time", "hit time, speed or impulse", [](Hit& h) { h.time = double{kNan}; });
        row("speed", "hit time, speed or impulse", [](Hit& h) { h.speed = kInfinity; });
        row("impulse", "hit time, speed or impulse", [](Hit& h) { h.impulse = kNan; });
        row("max distance", "max_distance", [](Hit& h) { h.constants.maxDistance = 0.0f; });
        row("power", "power", [](Hit& h) { h.constants.power = -0.1f; });
        row("max magnitude", "max_magnitude", [](Hit& h) { h.constants.maxMagnitude = kNan; });
    }
    void badHitsAreRefused() {
        QFETCH(Damage, damage);
        QFETCH(QString, where);
        Hit hit;
        damage(hit);
        const Result<Hit> result = checkedHit(hit);
        QVERIFY(!result.ok());
        QCOMPARE(QString::fromStdString(result.error().where), where);
        QVERIFY(!result.error().advice.empty());
    }

    void directionsBecomeUnit() {
        for (const float scale : {1.0f, 5.0f, 1e-3f, 1e-30f, 1e-44f, 1e30f, 1e38f}) {
            Hit hit;
            hit.direction = glm::vec3(0.0f, scale, -scale);
            const Result<Hit> result = checkedHit(hit);
            QVERIFY(result.ok());
            QVERIFY(glm::distance(result.value().direction, glm::vec3(0, std::sqrt(0.5f), -std::sqrt(0.5f))) <
                    1e-6f);
        }
    }

    /// A session read back must deform in every bit as before.
    void aCheckedHitStaysAsItIs() {
        std::mt19937 random(2);
        for (int i = 0; i < 100000; ++i) {
            Hit hit = test::randomHit(random, 10.0f);
            hit.direction *= 3.0f;
            const Hit once = checkedHit(hit).value();
            const Hit twice = checkedHit(once).value();
            QVERIFY(std::memcmp(&once.direction, &twice.direction, sizeof(glm::vec3)) == 0);
        }
    }
};

HITSCOPE_TEST(HitTest, QCoreApplication)

}  // namespace hitscope::deform_hit_test

#include "deform_hit_test.moc"
