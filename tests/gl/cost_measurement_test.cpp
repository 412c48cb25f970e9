// SPDX-License-Identifier: GPL-3.0-or-later
// Frames and hits measured in the background.
#include "scene/measure_costs.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "pipeline/deformation_pipeline.h"
#include "session/frame_costs.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::cost_measurement_test {

namespace {

CostPlan smallPlan() {
    CostPlan plan;
    plan.width = 64;
    plan.height = 48;
    plan.hits = {0, 3, 7};
    plan.samples = 2;
    return plan;
}

/// Leaves out those that this renderer cannot run. A context of its own, as the measurement has one.
void keepAvailable(std::vector<PipelineKind>& pipelines) {
    test::GlFixture context;
    if (context.open()) {
        std::erase_if(pipelines, [](PipelineKind kind) { return whyUnavailable(kind).has_value(); });
    }
}

}  // namespace

class CostMeasurementTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void measuresEveryPipeline() {
        CostPlan plan = smallPlan();
        keepAvailable(plan.pipelines);
        Session session;
        loadPaperRow(session, 0);
        CostMeasurement measurement(costMeter());
        const QSignalSpy progressed(&measurement, &CostMeasurement::progressed);
        const QSignalSpy failed(&measurement, &CostMeasurement::failed);
        QSignalSpy finished(&measurement, &CostMeasurement::finished);
        measurement.start(session, Camera(), plan);
        QVERIFY(measurement.isRunning());
        QVERIFY(finished.wait(kPatience));
        QVERIFY(!measurement.isRunning());
        QCOMPARE(failed.size(), 0);
        constexpr int kSteps = 3 * 2;  // numbers of hits, samples
        QCOMPARE(progressed.size(), kSteps * static_cast<int>(plan.pipelines.size()));
        QCOMPARE(progressed.last(), QList<QVariant>({kSteps, kSteps}));
        for (const PipelineKind pipeline : plan.pipelines) {
            const std::vector<CostPoint> points = measurement.curves().points(pipeline);
            QCOMPARE(points.size(), std::size_t{3});
            QCOMPARE(points[2].at, 7.0);
            for (const CostPoint& point : points) {
                QVERIFY(point.frame.value_or(0.0) > 0.0);
                QVERIFY(point.hit.value_or(0.0) > 0.0);
            }
        }
        QCOMPARE(session.hits().history().size(), std::size_t{0});
        QVERIFY(session.frameCosts().frames().empty());
    }

    void measuresSpheresOfManySizes() {
        SizePlan plan;
        plan.width = 64;
        plan.height = 48;
        plan.vertices = {500, 4000, 32000};
        plan.hits = 5;
        plan.samples = 2;
        keepAvailable(plan.pipelines);
        CostMeasurement measurement(costMeter());
        const QSignalSpy progressed(&measurement, &CostMeasurement::progressed);
        const QSignalSpy failed(&measurement, &CostMeasurement::failed);
        QSignalSpy finished(&measurement, &CostMeasurement::finished);
        measurement.start(plan);
        QVERIFY(finished.wait(kPatience));
        QCOMPARE(failed.size(), 0);
        const int steps = static_cast<int>(3 * plan.pipelines.size() * 2);
        QCOMPARE(progressed.last(), QList<QVariant>({steps, steps}));
        for (const PipelineKind pipeline : plan.pipelines) {
            const std::vector<CostPoint> points = measurement.curves().points(pipeline);
            QCOMPARE(points.size(), plan.vertices.size());
            for (std::size_t i = 0; i < points.size(); ++i) {
                const auto wanted = static_cast<double>(plan.vertices[i]);
                QVERIFY2(std::abs(points[i].at - wanted) < 0.15 * wanted,
                         qPrintable(QString::number(points[i].at)));
                QVERIFY(points[i].frame.value_or(0.0) > 0.0);
                QVERIFY(points[i].hit.value_or(0.0) > 0.0);
            }
        }
    }

    void isCancelledAndStartedAgain() {
        Session session;
        loadPaperRow(session, 0);
        CostMeasurement measurement(costMeter());
        QSignalSpy finished(&measurement, &CostMeasurement::finished);
        CostPlan endless = smallPlan();
        endless.samples = 1'000'000;
        measurement.start(session, Camera(), endless);
        QTest::qWait(50);
        measurement.start(session, Camera(), endless);
        QTest::qWait(50);
        QVERIFY(measurement.isRunning());
        measurement.cancel();
        QVERIFY(finished.wait(kPatience));
        QCOMPARE(finished.size(), 1);
        measurement.start(session, Camera(), endless);  // the destructor ends it
    }

    void saysWhyThereIsNothingToMeasure() {
        Session session;
        CostMeasurement measurement(costMeter());
        QSignalSpy failed(&measurement, &CostMeasurement::failed);
        measurement.start(session, Camera(), smallPlan());
        QVERIFY(failed.wait(kPatience));
        QVERIFY(failed.first().first().toString().contains(QStringLiteral("nothing to measure")));
    }
};

HITSCOPE_TEST(CostMeasurementTest, QCoreApplication)

}  // namespace hitscope::cost_measurement_test

#include "cost_measurement_test.moc"
