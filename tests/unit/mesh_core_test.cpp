// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/bounds.h"
#include "core/frame_times.h"
#include "core/parameter.h"
#include "core/result.h"
#include "support/test_program.h"

namespace hitscope::mesh_core_test {

class CoreTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingMeasuredIsAllZeros() {
        const FrameTimes::Summary summary = FrameTimes().summary(5.0);
        QCOMPARE(summary.framesPerSecond, 0.0);
        QCOMPARE(summary.worstCost, 0.0);
        QCOMPARE(summary.onePercentLow, 0.0);
    }

    void framesOfTheLastSecondAreCounted() {
        FrameTimes times;
        for (int i = 1; i <= 8; ++i) {
            times.add(0.25 * i, 0.01);  // 0.25 .. 2.0
        }
        // (1, 2]: the one that ended a full second ago belongs to the second before.
        QCOMPARE(times.summary(2.0).recent, std::size_t{4});
        QCOMPARE(times.summary(2.5).recent, std::size_t{2});
        QCOMPARE(times.summary(1.0).recent, std::size_t{4});
        QCOMPARE(times.summary(10.0).recent, std::size_t{0});
        // A rate is what the frame times allow, however few frames were asked for.
        QCOMPARE(times.summary(2.0).framesPerSecond, 100.0);
        QCOMPARE(times.summary(10.0).framesPerSecond, 0.0);
        QCOMPARE(times.summary(10.0).lastCost, 0.01);
    }

    void costsAreSummedUp() {
        FrameTimes times;
        for (const double cost : {0.5, 0.125, 0.25, 1.0}) {
            times.add(1.0, cost);
        }
        const FrameTimes::Summary summary = times.summary(1.0);
        QCOMPARE(summary.meanCost, 0.46875);
        QCOMPARE(summary.medianCost, 0.375);
        QCOMPARE(summary.worstCost, 1.0);
        QCOMPARE(summary.onePercentLow, 1.0);
        times.add(1.0, 4.0);
        QCOMPARE(times.summary(1.0).medianCost, 0.5);
        QCOMPARE(times.summary(1.0).onePercentLow, 0.25);
    }

    void theSlowestHundredthGivesTheLow() {
        FrameTimes times;
        for (int i = 0; i < 198; ++i) {
            times.add(1.0, 0.001);
        }
        times.add(1.0, 0.25);
        times.add(1.0, 0.75);
        QCOMPARE(times.summary(1.0).onePercentLow, 2.0);
    }

    void theOldestGiveWay() {
        FrameTimes times(3);
        for (int i = 1; i <= 5; ++i) {
            times.add(i, 0.1 * i);
        }
        const std::vector<FrameTimes::Sample> samples = times.samples();
        QCOMPARE(samples.size(), std::size_t{3});
        QCOMPARE(samples[0].end, 3.0);
        QCOMPARE(samples[1].end, 4.0);
        QCOMPARE(samples[2].end, 5.0);
        times.clear();
        QCOMPARE(times.size(), std::size_t{0});
        times.add(9.0, 0.1);
        QCOMPARE(times.samples().front().end, 9.0);
    }

    void errorsReadAsOneLine() {
        QCOMPARE(Error({"It is broken.", "a.obj", "Mend it."}).message(),
                 std::string("a.obj: It is broken. Mend it."));
        QCOMPARE(Error({"It is broken.", "", ""}).message(), std::string("It is broken."));
        const Result<int> good(3);
        const Result<int> bad(Error{"No.", "", ""});
        QVERIFY(good.ok() && good.value() == 3);
        QVERIFY(!bad && bad.error().what == "No.");
    }

    void parametersRefuseWhatIsOutside() {
        ParameterDescriptor parameter;
        parameter.minimum = 0.5;
        parameter.maximum = 2.0;
        QVERIFY(parameter.accepts(0.5) && parameter.accepts(2.0));
        QVERIFY(!parameter.accepts(0.49) && !parameter.accepts(2.01));
        QVERIFY(!parameter.accepts(std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(!parameter.accepts(std::numeric_limits<double>::infinity()));
    }

    void boundsGrow() {
        Bounds bounds;
        QVERIFY(bounds.empty());
        QCOMPARE(bounds.diagonal(), 0.0f);
        bounds.add(glm::vec3(1.0f, 2.0f, 3.0f));
        bounds.add(glm::vec3(-1.0f, 6.0f, 3.0f));
        QVERIFY(bounds.centre() == glm::vec3(0.0f, 4.0f, 3.0f));
        QVERIFY(bounds.size() == glm::vec3(2.0f, 4.0f, 0.0f));
    }
};

HITSCOPE_TEST(CoreTest, QCoreApplication)

}  // namespace hitscope::mesh_core_test

#include "mesh_core_test.moc"
