// SPDX-License-Identifier: GPL-3.0-or-later
// How large a picture is drawn while it moves, from the times that frames take.
#include "viewport/motion_scale.h"

#include <QTest>
#include <functional>

#include "support/test_program.h"

namespace hitscope::motion_scale_test {

namespace {

/// So many frames, each of which takes what is given for its scale; the last scale.
float moved(MotionScale& motion, int frames, const std::function<double(float)>& seconds) {
    for (int i = 0; i < frames; ++i) {
        motion.frameTook(seconds(motion.scale()));
    }
    return motion.scale();
}

}  // namespace

class MotionScaleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    static void staysFullSizeWhereFramesAreFast() {
        MotionScale motion;
        QCOMPARE(moved(motion, 100, [](float) { return 0.030; }), 1.0f);
    }

    static void pixelsGoWhereTheyCostTheTime_data() {
        QTest::addColumn<double>("full");  // seconds of a frame of full size
        QTest::addColumn<float>("scale");
        QTest::newRow("fast enough with half of them") << 0.050 << 0.70710678f;
        QTest::newRow("with a quarter") << 0.100 << 0.5f;
        QTest::newRow("never") << 1.0 << 0.5f;
    }
    static void pixelsGoWhereTheyCostTheTime() {
        QFETCH(double, full);
        QFETCH(float, scale);
        MotionScale motion;
        const auto byPixels = [full](float at) { return full * static_cast<double>(at * at); };
        QCOMPARE(moved(motion, 20, byPixels), scale);
        QCOMPARE(moved(motion, 200, byPixels), scale);  // it does not go up and down
    }

    static void staysFullSizeWherePixelsDoNotCostTheTime() {
        MotionScale motion;
        const auto byVertices = [](float at) { return 0.100 + 0.004 * static_cast<double>(at * at); };
        QCOMPARE(moved(motion, 20, byVertices), 1.0f);
        QCOMPARE(moved(motion, 200, byVertices), 1.0f);
        motion.forget();  // another scene
        QCOMPARE(moved(motion, 20, [](float at) { return 0.1 * static_cast<double>(at * at); }), 0.5f);
    }

    static void growsAgainWhereFramesAreFast() {
        MotionScale motion;
        QCOMPARE(moved(motion, 20, [](float at) { return 0.1 * static_cast<double>(at * at); }), 0.5f);
        QCOMPARE(moved(motion, 20, [](float) { return 0.004; }), 1.0f);
    }

    /// One frame that takes long, as one that compiles a program does, is not enough.
    static void aSlowFrameAloneChangesNothing() {
        MotionScale motion;
        motion.frameTook(0.060);
        QCOMPARE(moved(motion, 20, [](float) { return 0.010; }), 1.0f);
    }
};

HITSCOPE_TEST(MotionScaleTest, QCoreApplication)

}  // namespace hitscope::motion_scale_test

#include "motion_scale_test.moc"
