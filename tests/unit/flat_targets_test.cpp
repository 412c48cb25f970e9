// SPDX-License-Identifier: GPL-3.0-or-later
// Where the floor is under targets that are as flat as a sheet.
#include <QTest>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::flat_targets_test {

namespace {

TargetPlan flatSheet() {
    TargetPlan plan = planMesh(makeSheet(4, 4, 2.0f, 2.0f));
    plan.transform.rotation = glm::angleAxis(-1.57079633f, glm::vec3(1.0f, 0.0f, 0.0f));
    return plan;
}

bool hovers(const Session& session, std::size_t target) {
    const float gap = session.targets()[target]->worldBounds().min.y - session.targets().floorHeight();
    return std::abs(gap - 0.5f) < 1.0e-4f;
}

}  // namespace

class FlatTargetsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSheetHovers() {
        Session session;
        session.loadScene({QStringLiteral("Sheet"), {flatSheet()}, {}});
        QVERIFY(hovers(session, 0));
        session.loadScene({QStringLiteral("Both"), {flatSheet(), planMesh(makeCube(2, 0.25f))}, {}});
        QVERIFY(hovers(session, 0));  // the cube ends above the floor
    }

    void soDoesOneThatIsAdded() {
        Session session;
        session.loadScene({QStringLiteral("Cube"), {planMesh(makeCube(2, 1.0f))}, {}});
        QCOMPARE(session.targets().floorHeight(), -1.0f);
        TargetPlan low = flatSheet();
        low.transform.position.y = -1.0f;
        session.targets().add({low});
        QCOMPARE(session.targets().floorHeight(), -1.0f);
        QVERIFY(hovers(session, 1));
    }

    /// Straight down, until it has pushed the sheet to below where it was at first by more than once.
    void aShotIntoItsDentHits() {
        Session session;
        session.loadScene({QStringLiteral("Sheet"), {flatSheet()}, {}});
        for (int shot = 0; shot < 3; ++shot) {
            const auto met =
                session.simulation().physics().castRay({0.0f, 10.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, 100.0f);
            QVERIFY(met);
            QCOMPARE(met->target, session.targets()[0]->id);
            Hit hit;
            hit.target = met->target;
            hit.point = glm::vec3(0.0f);
            hit.direction = {0.0f, 0.0f, -1.0f};
            hit.normal = {0.0f, 0.0f, 1.0f};
            hit.constants = {0.4f, 0.05f, 0.12f};
            QVERIFY(session.hits().add(hit).ok());
            session.simulation().updateColliders();
        }
    }
};

HITSCOPE_TEST(FlatTargetsTest, QCoreApplication)

}  // namespace hitscope::flat_targets_test

#include "flat_targets_test.moc"
