// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/cost_curves.h"
#include "support/test_program.h"

#include <QTest>

namespace hitscope::cost_curves_test {

class CostCurvesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void pointsAreMediansOfTheLatest();
    void lengthsCloseTogetherShareAPoint();
    void crossoverOfStraightLines();
    void noCrossover();
    void oneSlowFrameIsNoCrossover();
};

void CostCurvesTest::pointsAreMediansOfTheLatest() {
    CostCurves curves;
    QVERIFY(curves.points(PipelineKind::Compute).empty());
    for (const double seconds : {0.5, 0.1, 0.2}) {
        curves.addFrame(PipelineKind::UniformArray, 3, seconds);
    }
    curves.addHit(PipelineKind::UniformArray, 4, 0.01);
    std::vector<CostPoint> points = curves.points(PipelineKind::UniformArray);
    QCOMPARE(points.size(), std::size_t{2});
    QCOMPARE(points[0].at, 3.0);
    QCOMPARE(points[0].frame.value_or(0.0), 0.2);
    QVERIFY(!points[0].hit && !points[1].frame);
    QCOMPARE(points[1].hit.value_or(0.0), 0.01);
    QVERIFY(curves.points(PipelineKind::TransformFeedback).empty());
    for (int i = 0; i < 100; ++i) {
        curves.addFrame(PipelineKind::UniformArray, 3, 1.0);
    }
    points = curves.points(PipelineKind::UniformArray);
    QCOMPARE(points[0].frame.value_or(0.0), 1.0);
    curves.clear();
    QVERIFY(curves.points(PipelineKind::UniformArray).empty());
}

void CostCurvesTest::lengthsCloseTogetherShareAPoint() {
    CostCurves curves;
    for (std::size_t hits = 0; hits < 1024; ++hits) {
        curves.addFrame(PipelineKind::UniformArray, hits, 0.1);
    }
    const std::vector<CostPoint> points = curves.points(PipelineKind::UniformArray);
    QCOMPARE(points.size(), std::size_t{16 + 6 * 8});  // 0 to 15, then eight an octave
    for (std::size_t i = 1; i < points.size(); ++i) {
        QVERIFY(points[i].at > points[i - 1].at);
        QVERIFY(points[i].at <= std::max(points[i - 1].at * 1.14, points[i - 1].at + 1.0));
    }
}

void CostCurvesTest::crossoverOfStraightLines() {
    // Frames: 1 + h/100 over 3; with a hit: 1 + h/100 over 3 + 2.
    const std::vector<CostPoint> a = {{0.0, 1.0, 0.0}, {100.0, 2.0, 0.0}, {600.0, 7.0, 0.0}};
    const std::vector<CostPoint> b = {{0.0, 3.0, 2.0}, {600.0, 3.0, 2.0}};
    QCOMPARE(crossover(a, b, CostOf::Frame).value_or(0.0), 200.0);
    QCOMPARE(crossover(a, b, CostOf::FrameWithHit).value_or(0.0), 400.0);
    QVERIFY(!crossover(b, a, CostOf::Frame));
    // More from the start.
    const std::vector<CostPoint> cheap = {{50.0, 0.5, {}}, {600.0, 0.5, {}}};
    QCOMPARE(crossover(a, cheap, CostOf::Frame).value_or(-1.0), 50.0);
    QVERIFY(!crossover(a, cheap, CostOf::FrameWithHit));  // what a hit costs is not known
}

void CostCurvesTest::noCrossover() {
    const std::vector<CostPoint> a = {{0.0, 1.0, 0.0}, {100.0, 2.0, 0.0}};
    const std::vector<CostPoint> apart = {{200.0, 1.0, 0.0}, {300.0, 1.0, 0.0}};
    QVERIFY(!crossover(a, apart, CostOf::Frame));
    QVERIFY(!crossover(a, {}, CostOf::Frame));
    QVERIFY(!crossover(a, a, CostOf::Frame));
}

void CostCurvesTest::oneSlowFrameIsNoCrossover() {
    const std::vector<CostPoint> a = {{0.0, 9.0, {}}, {10.0, 1.0, {}}, {20.0, 3.0, {}}};
    const std::vector<CostPoint> b = {{0.0, 2.0, {}}, {20.0, 2.0, {}}};
    QCOMPARE(crossover(a, b, CostOf::Frame).value_or(0.0), 15.0);
}

HITSCOPE_TEST(CostCurvesTest, QCoreApplication)

}  // namespace hitscope::cost_curves_test

#include "cost_curves_test.moc"
