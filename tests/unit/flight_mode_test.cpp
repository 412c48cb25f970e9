// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/flight_mode.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::flight_mode_test {

namespace {

constexpr float kPaperRadius = 0.1f;

/// A sphere of that extent, metres.
MeshData sphere(float extent) {
    MeshData mesh = makeHighPolySphere(2.5f);
    for (glm::vec3& position : mesh.positions) {
        position *= extent / kUsualExtent;
    }
    mesh.filePositions.clear();
    return mesh;
}

bool isNear(float value, float wanted) {
    return std::abs(value - wanted) <= 1e-5f * std::abs(wanted);
}

}  // namespace

/// What each flight mode makes of a shot, at targets and distances of all sizes.
class FlightModeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void paperAndOwnGoByNoTarget() {
        ProjectileSettings own;
        own.speed = 77.0f;
        own.radius = 0.02f;
        own.gravity = 1.0f;
        own.mass = 3.0f;
        QVERIFY(projectileOf(FlightMode::Own, own, 1000.0f, 1e6f) == own);
        const ProjectileSettings paper = projectileOf(FlightMode::Paper, own, 1000.0f, 1e6f);
        QCOMPARE(paper.speed, 30.0f);
        QCOMPARE(paper.radius, kPaperRadius);
        QCOMPARE(paper.lifetime, 5.0f);
        QCOMPARE(paper.gravity, 9.81f);
        QCOMPARE(paper.mass, 3.0f);
    }

    void quickGoesByTargetAndDistance() {
        const ProjectileSettings own;
        const ProjectileSettings far = projectileOf(FlightMode::Quick, own, 5.0f, 40.0f);
        QVERIFY(isNear(far.speed, 40.0f / kQuickFlight));
        QCOMPARE(far.radius, kPaperRadius);
        QVERIFY(isNear(far.mass * far.speed, own.mass * own.speed));
        const ProjectileSettings large = projectileOf(FlightMode::Quick, own, 500.0f, 10.0f);
        QVERIFY(isNear(large.speed, 3000.0f));
        QVERIFY(isNear(large.gravity, 981.0f));
        QVERIFY(large.radius <= 2.5f);  // it would start in the target
        QVERIFY(isNear(projectileOf(FlightMode::Instant, own, 500.0f, 10.0f).radius, 10.0f));
    }

    void hitsAnySize_data() {
        QTest::addColumn<float>("extent");
        QTest::addColumn<float>("away");
        for (int power = -4; power <= 5; ++power) {
            for (const float away : {0.7f, 3.0f, 40.0f}) {
                QTest::addRow("1e%d m, %g extents away", power, static_cast<double>(away))
                    << std::pow(10.0f, static_cast<float>(power)) << away;
            }
        }
    }
    /// Flies as it does from a click, and from several sides: what it strikes is where it was aimed at,
    /// within the time that a quick flight may take, and it bounces.
    void hitsAnySize() {
        QFETCH(float, extent);
        QFETCH(float, away);
        Session session;
        loadMesh(session, sphere(extent));
        const Bounds bounds = session.targets().bounds();
        std::size_t hits = 0;
        for (const glm::vec3& side : {glm::vec3(0, 0, 1), glm::vec3(1, 0.5f, 0.2f), glm::vec3(-1, 2, 0.3f)}) {
            const glm::vec3 from = bounds.centre() + glm::normalize(side) * (away * extent);
            const glm::vec3 ahead = -glm::normalize(side);
            const auto met = session.simulation().physics().castRay(from, ahead, 1e7f);
            QVERIFY(met && met->target);
            const ProjectileSettings shot = projectileOf(FlightMode::Quick, session.settings().projectile(),
                                                         extent, glm::distance(from, met->point));
            while (session.simulation().isMoving()) {
                session.simulation().advance(0.25);  // what bounced off before would be in the way
            }
            const double before = session.simulation().physics().clock().time();
            session.simulation().fire({0.0, {from, ahead}, shot, false});
            while (session.hits().history().size() == hits &&
                   session.simulation().physics().clock().time() < before + 0.5) {
                session.simulation().stepOnce();
            }
            QCOMPARE(session.hits().history().size(), ++hits);
            const Hit& hit = session.hits().history().hits().back();
            QVERIFY(hit.time - before <= 0.12);
            const Target& target = *session.targets().front();
            const float off = glm::distance(target.transform.toWorld(hit.point), met->point);
            QVERIFY2(off < 0.03f * extent, qPrintable(QString::number(static_cast<double>(off / extent))));
            QVERIFY(isNear(hit.constants.maxDistance, 0.1f * extent));
            const float wanted = 1.36f * shot.mass * -glm::dot(hit.normal, hit.direction) * hit.speed;
            QVERIFY2(std::abs(hit.impulse - wanted) < 0.05f * wanted,
                     qPrintable(QStringLiteral("%1 for %2").arg(hit.impulse).arg(wanted)));
            session.undo();  // its dent would be in the way
            session.simulation().fire({0.0, {from, ahead}, shot, true});
            QCOMPARE(session.hits().history().size(), hits);
            QVERIFY(glm::distance(target.transform.toWorld(session.hits().history().hits().back().point),
                                  met->point) < 1e-5f * (extent + glm::length(met->point)));
        }
    }
};

HITSCOPE_TEST(FlightModeTest, QCoreApplication)

}  // namespace hitscope::flight_mode_test

#include "flight_mode_test.moc"
