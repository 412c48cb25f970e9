// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cstring>
#include <functional>
#include <limits>

#include "deform/hit.h"
#include "deform/hit_history.h"
#include "deform_support.h"
#include "support/test_program.h"

using namespace hitscope;

using Damage = std::function<void(Hit&)>;
Q_DECLARE_METATYPE(Damage)

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Hit hitOn(std::uint32_t target, float x = 0.0f) {
    Hit hit;
    hit.target = {target};
    hit.point.x = x;
    return hit;
}

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

    void everyChangeIsAnEditWithItsInverse() {
        HitHistory history;
        std::vector<std::vector<Hit>> states;
        std::vector<HistoryEdit> edits;
        const auto now = [&history] {
            return std::vector<Hit>(history.hits().begin(), history.hits().end());
        };
        states.push_back(now());
        const auto made = [&](HistoryEdit edit) {
            edits.push_back(std::move(edit));
            states.push_back(now());
        };
        for (std::uint32_t i = 0; i < 6; ++i) {
            made(history.append(hitOn(1 + i % 2, static_cast<float>(i))));
        }
        QCOMPARE(history.hits()[1].target.value, 2u);
        made(history.remove(1));
        QCOMPARE(history.hits()[1].point.x, 2.0f);
        made(history.setEnabled(2, false));
        QVERIFY(!history.hits()[2].enabled);
        made(history.setConstantsOfAll([](const Hit&) {
            return DeformationConstants{.maxDistance = 1.0f, .power = 0.2f, .maxMagnitude = 0.4f};
        }));
        QCOMPARE(history.hits()[0].constants.power, 0.2f);
        made(history.removeTarget({1}));
        QCOMPARE(history.size(), std::size_t{2});
        const std::vector<Hit> other = {hitOn(3), history.hits()[0], hitOn(4)};
        made(history.splice(0, 2, other));
        QCOMPARE(now(), other);
        made(history.clear());
        QCOMPARE(history.size(), std::size_t{0});
        QCOMPARE(history.revision(), edits.size());

        for (std::size_t i = edits.size(); i-- > 0;) {
            history.undo(edits[i]);
            QCOMPARE(now(), states[i]);
        }
        for (std::size_t i = 0; i < edits.size(); ++i) {
            history.redo(edits[i]);
            QCOMPARE(now(), states[i + 1]);
        }
    }

    void movingPutsTheHitInItsNewPlace_data() {
        QTest::addColumn<int>("from");
        QTest::addColumn<int>("to");
        QTest::addColumn<QString>("order");
        QTest::newRow("down") << 1 << 3 << "02314";
        QTest::newRow("up") << 3 << 0 << "30124";
        QTest::newRow("to the end") << 0 << 4 << "12340";
        QTest::newRow("nowhere") << 2 << 2 << "01234";
    }
    void movingPutsTheHitInItsNewPlace() {
        QFETCH(const int, from);
        QFETCH(const int, to);
        QFETCH(const QString, order);
        HitHistory history;
        for (std::uint32_t i = 0; i < 5; ++i) {
            history.append(hitOn(1, static_cast<float>(i)));
        }
        const std::vector<HistoryEdit> edits =
            history.move(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
        QString places;
        for (const Hit& hit : history.hits()) {
            places += QString::number(static_cast<int>(hit.point.x));
        }
        QCOMPARE(places, order);
        for (const HistoryEdit& edit : edits) {
            QCOMPARE(edit.before.size() + edit.after.size(), std::size_t{1});
        }
    }

    void whatDoesNotChangeIsNoEdit() {
        HitHistory history;
        history.append(hitOn(1, 0.0f));
        history.append(hitOn(2, 1.0f));
        const std::uint64_t revision = history.revision();
        history.removeTarget({77});
        history.setEnabled(0, true);
        history.setConstantsOfAll([](const Hit& hit) { return hit.constants; });
        QCOMPARE(history.revision(), revision);
        const std::vector<Hit> hits = {history.hits()[0], hitOn(3), history.hits()[1]};
        const HistoryEdit edit = history.splice(0, 2, hits);
        QCOMPARE(edit.first, std::size_t{1});
        QVERIFY(edit.before.empty());
        QCOMPARE(edit.after.size(), std::size_t{1});
    }

    void followersSeeEveryEditOrStartOver() {
        HitHistory history;
        HitHistory follower;
        std::uint64_t seen = 0;
        std::mt19937 random(5);
        std::size_t startedOver = 0;
        for (int frame = 0; frame < 200; ++frame) {
            const int changes = frame == 150 ? 3000 : 3;
            for (int i = 0; i < changes; ++i) {
                if (history.size() > 5 && random() % 3 == 0) {
                    history.move(random() % history.size(), random() % history.size());
                } else {
                    history.append(hitOn(1, static_cast<float>(random() % 1000)));
                }
            }
            if (const auto edits = history.editsSince(seen)) {
                for (const HistoryEdit& edit : *edits) {
                    follower.redo(edit);
                }
            } else {
                follower.splice(0, follower.size(), history.hits());
                ++startedOver;
            }
            seen = history.revision();
            QVERIFY(std::equal(history.hits().begin(), history.hits().end(), follower.hits().begin(),
                               follower.hits().end()));
        }
        QCOMPARE(startedOver, std::size_t{1});
    }

    void disabledHitsAreOnNoTarget() {
        HitHistory history;
        history.append(hitOn(1, 0.0f));
        history.append(hitOn(1, 1.0f));
        history.append(hitOn(2, 2.0f));
        history.setEnabled(0, false);
        const std::vector<Hit> hits = history.hitsOn({1});
        QCOMPARE(hits.size(), std::size_t{1});
        QCOMPARE(hits[0].point.x, 1.0f);
    }
};

HITSCOPE_TEST(HitTest, QCoreApplication)
#include "deform_hit_test.moc"
