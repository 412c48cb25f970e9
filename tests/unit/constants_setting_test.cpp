// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/constants_setting.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "deform/reference.h"
#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::constants_setting_test {

namespace {

/// A sphere of that diameter (metres) in its own coordinates, struck once from the side: the greatest
/// displacement over the diameter, and the share of vertices that moved.
struct Dent {
    double depth = 0.0;
    double share = 0.0;
};

Dent dentIn(float diameter, bool relative) {
    Session session;
    loadMesh(session, makeUvSphere(32, 16, 0.5f * diameter));
    if (!session.settings().setConstants(ConstantsSetting{DeformationConstants{}, relative})) {
        return {};
    }
    const Bounds bounds = session.targets().bounds();
    Ray ray;
    ray.origin = bounds.centre() + glm::vec3(0.0f, 0.0f, 3.0f * diameter);
    ray.direction = glm::vec3(0.0f, 0.0f, -1.0f);
    if (!session.simulation().hitscan(ray)) {
        return {};
    }
    const Target& target = *session.targets().front();
    ReferenceDeformation reference(target.deformed.render());
    reference.apply(session.hits().history().hits());
    Dent dent;
    for (std::size_t i = 0; i < reference.vertices().size(); ++i) {
        const double moved =
            glm::distance(reference.vertices()[i].position, target.deformed.render().vertices[i].position);
        dent.depth = std::max(dent.depth, moved / diameter);
        dent.share += moved > 0.0 ? 1.0 / static_cast<double>(reference.vertices().size()) : 0.0;
    }
    return dent;
}

}  // namespace

class ConstantsSettingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void factorsAreReadable() {
        QCOMPARE(sizeFactor(5.0f), 1.0f);
        QCOMPARE(sizeFactor(5.0000005f), 1.0f);
        QCOMPARE(sizeFactor(4.9999995f), 1.0f);
        QCOMPARE(sizeFactor(0.617f), 0.123f);
        QCOMPARE(sizeFactor(1.0e-4f), 2.0e-5f);
        QCOMPARE(sizeFactor(1.0e6f), 2.0e5f);
        QCOMPARE(sizeFactor(0.0f), 1.0f);
        QCOMPARE(sizeFactor(std::numeric_limits<float>::infinity()), 1.0f);
    }

    void thePapersTargetsHaveThePapersConstants() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        QVERIFY(session.settings().constantsSetting().relative);
        for (const std::unique_ptr<Target>& target : session.targets()) {
            QVERIFY(session.settings().constantsOn(*target) == DeformationConstants{});
        }
    }

    void lengthsGrowWithTheTargetAndPowerWithItsSquare() {
        const DeformationConstants ten = constantsOn(50.0f, {});
        QCOMPARE(ten.maxDistance, 5.0f);
        QCOMPARE(ten.power, 5.0f);
        QCOMPARE(ten.maxMagnitude, 3.0f);
        QVERIFY(constantsOn(50.0f, {.constants = {}, .relative = false}) == DeformationConstants{});
    }

    void meshesOfAnySizeDentAlike_data() {
        QTest::addColumn<float>("diameter");
        for (const float diameter : {1.0e-4f, 0.02f, 5.0f, 300.0f, 1.0e6f}) {
            QTest::addRow("%g m", static_cast<double>(diameter)) << diameter;
        }
    }
    void meshesOfAnySizeDentAlike() {
        QFETCH(float, diameter);
        const Dent usual = dentIn(5.0f, true);
        const Dent dent = dentIn(diameter, true);
        QVERIFY(usual.depth > 0.01);
        QVERIFY2(std::abs(dent.depth / usual.depth - 1.0) < 0.02, qPrintable(QString::number(dent.depth)));
        QVERIFY2(std::abs(dent.share / usual.share - 1.0) < 0.1, qPrintable(QString::number(dent.share)));
    }

    void absoluteConstantsMakeTheSameDentEverywhere() {
        QVERIFY(dentIn(300.0f, false).depth < 0.01);
        QCOMPARE(dentIn(0.02f, false).share, 1.0);
    }

    void valuesAreAsPeopleWriteThem() {
        const DeformationConstants small = constantsOn(0.45f, {});
        QCOMPARE(small.maxDistance, 0.045f);
        QCOMPARE(small.maxMagnitude, 0.027f);  // 0.3f * 0.09f is the float after it
        QCOMPARE(constantsOn(0.0617f, {}).power, 7.5645e-6f);
        QCOMPARE(constantsOn(61'700.0f, {}).maxMagnitude, 3690.0f);
    }

    void hitsMadeGetThemOnRequestByTarget() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        Hit hit;
        hit.target = session.targets().front()->id;
        QVERIFY(session.hits().add(hit).ok());
        ConstantsSetting setting;
        setting.constants.power = 0.07f;
        QVERIFY(session.settings().setConstants(setting).ok());
        QCOMPARE(session.hits().history().hits()[0].constants.power, 0.05f);
        session.hits().giveConstantsToAll();
        QCOMPARE(session.hits().history().hits()[0].constants.power, 0.07f);
        session.undo();
        QCOMPARE(session.hits().history().hits()[0].constants.power, 0.05f);
        QCOMPARE(session.settings().constants().power, 0.07f);
        session.undo();
        QCOMPARE(session.settings().constants().power, 0.05f);
    }
};

HITSCOPE_TEST(ConstantsSettingTest, QCoreApplication)

}  // namespace hitscope::constants_setting_test

#include "constants_setting_test.moc"
