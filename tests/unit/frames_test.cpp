// SPDX-License-Identifier: GPL-3.0-or-later
// What frames and hits cost, without a GPU: the statistics, the ring, and costs that stay with their hits.
#include <QSignalSpy>
#include <QTest>
#include <vector>

#include "core/frame_times.h"
#include "core/ring.h"
#include "session/frame_costs.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::frames_test {

namespace {

void addHits(Session& session, int count) {
    std::vector<Hit> hits(static_cast<std::size_t>(count));
    for (Hit& hit : hits) {
        hit.target = session.targets().front()->id;
        hit.point = {0.0f, 0.0f, 2.5f};
    }
    QVERIFY(session.hits().add(hits).ok());
}

double cpuOf(const Session& session, std::size_t hit) {
    const std::optional<HitCost> cost = session.frameCosts().hitCost(hit);
    return cost ? cost->cpu : -1.0;
}

}  // namespace

class FramesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void ringKeepsTheLast();
    void percentilesOfKnownFrames();
    void framesAddUp();
    void gpuTimesFindTheirFrame();
    void costsAreSharedAmongHits();
    void costsStayWithTheirHits();
};

void FramesTest::ringKeepsTheLast() {
    Ring<int> ring(3);
    QVERIFY(ring.empty());
    for (int i = 1; i <= 5; ++i) {
        ring.push(i);
        QCOMPARE(ring.back(), i);
    }
    QCOMPARE(ring.size(), std::size_t{3});
    QCOMPARE(ring.capacity(), std::size_t{3});
    QCOMPARE(ring[0], 3);
    QCOMPARE(ring[2], 5);
    ring[1] = 7;
    QCOMPARE(ring[1], 7);
    ring.clear();
    ring.push(9);
    QCOMPARE(ring.size(), std::size_t{1});
    QCOMPARE(ring[0], 9);
}

void FramesTest::percentilesOfKnownFrames() {
    FrameTimes times(1000);
    for (int i = 200; i >= 1; --i) {
        times.add(0.0, 0.001 * i);
    }
    const FrameTimes::Summary summary = times.summary(0.5);
    QCOMPARE(summary.percentile99Cost, 0.198);  // 198 of 200 took that long or less
    QCOMPARE(summary.worstCost, 0.2);
    QCOMPARE(summary.medianCost, 0.1005);
    QCOMPARE(summary.meanCost, 0.1005);
    QCOMPARE(summary.onePercentLow, 1.0 / 0.1995);

    FrameTimes one;
    one.add(0.0, 0.02);
    QCOMPARE(one.summary(0.5).percentile99Cost, 0.02);
}

void FramesTest::framesAddUp() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    addHits(session, 2);
    FrameCosts& costs = session.frameCosts();
    const QSignalSpy ended(&costs, &FrameCosts::frameEnded);
    costs.addPhysics(0.001);
    costs.addPhysics(0.002);
    FrameCost cost;
    cost.deformation = 0.004;
    cost.readBack = 0.008;
    cost.drawing = 0.016;
    FrameCost before;
    before.deformation = 0.1;
    before.readBack = 0.2;
    before.drawing = 9.0;
    before.hits = 3;
    costs.addWork(before);
    costs.addFrame(cost);
    QCOMPARE(costs.frames().back().total, 0.331);
    costs.endFrame(0.04);
    QCOMPARE(ended.size(), 1);
    const FrameCost& first = costs.frames().back();
    QCOMPARE(first.cpu, 0.331);
    QCOMPARE(first.hits, 3u);
    QCOMPARE(first.physics, 0.003);
    QCOMPARE(first.total, 0.04);
    QCOMPARE(first.history, 2u);
    QCOMPARE(first.pipeline, session.settings().pipeline());
    QVERIFY(!first.gpu);
    costs.addFrame({});
    QCOMPARE(costs.frames().back().physics, 0.0);
    QCOMPARE(costs.frames().back().number, first.number + 1);
}

void FramesTest::gpuTimesFindTheirFrame() {
    Session session;
    FrameCosts& costs = session.frameCosts();
    for (int i = 0; i < 4; ++i) {
        costs.addFrame({});
        costs.addWork({});
    }
    const std::uint64_t second = costs.frames()[1].number;
    costs.addGpuTimes(second, 0.01, 0.002);
    costs.addGpuTimes(second + 1, 0.5, 0.25);  // on the way to the third
    costs.addGpuTimes(costs.nextFrame(), 9.0, 9.0);
    QVERIFY(!costs.frames()[0].gpu && !costs.frames()[3].gpu);
    QCOMPARE(costs.frames()[2].gpu.value_or(0.0), 0.5);
    costs.addGpuTimes(second + 2, 0.25, 0.25);
    QCOMPARE(costs.frames()[2].gpu.value_or(0.0), 0.75);
    QCOMPARE(costs.frames()[2].gpuDeformation.value_or(0.0), 0.5);
    QCOMPARE(costs.frames()[1].gpu.value_or(0.0), 0.01);
    QCOMPARE(costs.frames()[1].gpuDeformation.value_or(0.0), 0.002);
}

void FramesTest::costsAreSharedAmongHits() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    addHits(session, 5);
    FrameCosts& costs = session.frameCosts();
    QVERIFY(!costs.hitCost(0));
    const QSignalSpy changed(&costs, &FrameCosts::hitCostsChanged);
    const std::uint64_t frame = costs.nextFrame();
    costs.addApplied(frame, 1, 4, 0.008);
    costs.addFrame({});
    QVERIFY(!costs.hitCost(0));
    QCOMPARE(costs.hitCost(4), std::optional(HitCost{0.002, {}, 4, session.settings().pipeline()}));
    QCOMPARE(changed.last(), QList<QVariant>({1, 4}));
    costs.addGpuTimes(frame, 0.5, 0.04);
    QCOMPARE(costs.hitCost(1), std::optional(HitCost{0.002, 0.01, 4, session.settings().pipeline()}));
    QCOMPARE(changed.last(), QList<QVariant>({1, 4}));

    // Another pipeline applies all of them anew.
    session.settings().setPipeline(PipelineKind::UniformArray);
    costs.addApplied(costs.nextFrame(), 0, 5, 0.005);
    QCOMPARE(costs.hitCost(3), std::optional(HitCost{0.001, {}, 5, PipelineKind::UniformArray}));
    loadPaperRow(session, 0);
    addHits(session, 1);
    QVERIFY(!costs.hitCost(0));
}

void FramesTest::costsStayWithTheirHits() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    FrameCosts& costs = session.frameCosts();
    for (std::size_t i = 0; i < 4; ++i) {
        addHits(session, 1);
        costs.addApplied(costs.nextFrame(), i, 1, 0.001 * static_cast<double>(i + 1));
        costs.addWork({});
    }
    session.hits().remove(1);
    QCOMPARE(cpuOf(session, 0), 0.001);
    QCOMPARE(cpuOf(session, 1), 0.003);
    QCOMPARE(cpuOf(session, 2), 0.004);
    session.undo();
    QCOMPARE(cpuOf(session, 1), -1.0);  // put back among the others: its own cost is not known
    QCOMPARE(cpuOf(session, 3), 0.004);
    session.hits().clear();
    addHits(session, 1);
    QVERIFY(!costs.hitCost(0));
}

HITSCOPE_TEST(FramesTest, QCoreApplication)

}  // namespace hitscope::frames_test

#include "frames_test.moc"
