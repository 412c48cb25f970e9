// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a picture is drawn while it moves, from the times that frames take.
#include "viewport/motion_detail.h"

#include <QTest>
#include <functional>

#include "support/test_program.h"

namespace hitscope::motion_detail_test {

namespace {

/// So many frames, each of which takes what is given for its scale; the last scale.
float moved(MotionDetail& motion, int frames, const std::function<double(float)>& seconds) {
    for (int i = 0; i < frames; ++i) {
        motion.frameTook(seconds(motion.detail().scale));
    }
    return motion.detail().scale;
}

}  // namespace

class MotionDetailTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    static void staysFullSizeWhereFramesAreFast() {
        MotionDetail motion;
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
        MotionDetail motion;
        const auto byPixels = [full](float at) { return full * static_cast<double>(at * at); };
        QCOMPARE(moved(motion, 20, byPixels), scale);
        QCOMPARE(moved(motion, 200, byPixels), scale);  // it does not go up and down
    }

    static void followsTheTimeThatFramesMayTake() {
        const auto byPixels = [](float at) { return 0.025 * static_cast<double>(at * at); };
        MotionDetail motion;
        QCOMPARE(moved(motion, 20, byPixels), 1.0f);
        motion.setLongestFrame(MotionDetail::kLongestSoftwareFrame);
        QCOMPARE(moved(motion, 20, byPixels), 0.70710678f);
        motion.forget();  // another scene, on the same renderer
        QCOMPARE(moved(motion, 20, byPixels), 0.70710678f);
        QCOMPARE(moved(motion, 200, byPixels), 0.70710678f);
    }

    static void staysFullSizeWherePixelsDoNotCostTheTime() {
        MotionDetail motion;
        const auto byVertices = [](float at) { return 0.100 + 0.004 * static_cast<double>(at * at); };
        QCOMPARE(moved(motion, 20, byVertices), 1.0f);
        int small = 0;
        for (int i = 0; i < 1000; ++i) {
            small += moved(motion, 1, byVertices) < 1.0f ? 1 : 0;
        }
        QVERIFY2(small < 50, qPrintable(QString::number(small)));  // it is tried now and then
        motion.forget();                                           // another scene
        QCOMPARE(moved(motion, 20, [](float at) { return 0.1 * static_cast<double>(at * at); }), 0.5f);
    }

    static void whatWasNoHelpIsTriedAgainWhenTold() {
        MotionDetail motion;
        QCOMPARE(moved(motion, 20, [](float) { return 0.1; }), 1.0f);
        const auto byPixels = [](float at) { return 0.1 * static_cast<double>(at * at); };
        QCOMPARE(moved(motion, 20, byPixels), 1.0f);
        motion.tryAgain();  // one has come closer
        QCOMPARE(moved(motion, 20, byPixels), 0.5f);
    }

    /// Another program took the processor when it was tried.
    static void whatWasNoHelpIsTriedAgainLater() {
        MotionDetail motion;
        QCOMPARE(moved(motion, 20, [](float) { return 0.1; }), 1.0f);
        const auto byPixels = [](float at) { return 0.1 * static_cast<double>(at * at); };
        QCOMPARE(moved(motion, 100, byPixels), 0.5f);
    }

    static void quarterAtOnceWhereHalfWillNotDo() {
        MotionDetail motion;
        const auto byPixels = [](float at) { return 0.1 * static_cast<double>(at * at); };
        QCOMPARE(moved(motion, 3, byPixels), 0.5f);
        MotionDetail noHelp;
        QCOMPARE(moved(noHelp, 7, [](float) { return 0.1; }), 1.0f);
    }

    static void onlyPixelsAreLeftWhereTrianglesAreFew() {
        MotionDetail motion;
        motion.setCoarsePart(0.05f);
        motion.takeCoarse();
        QCOMPARE(moved(motion, 3, [](float at) { return 0.1 * static_cast<double>(at * at); }), 0.5f);
        QVERIFY(motion.detail().coarse);
    }

    static void growsAgainWhereFramesAreFast() {
        MotionDetail motion;
        QCOMPARE(moved(motion, 20, [](float at) { return 0.1 * static_cast<double>(at * at); }), 0.5f);
        QCOMPARE(moved(motion, 20, [](float) { return 0.004; }), 1.0f);
    }

    static void trianglesGoFirst_data() {
        QTest::addColumn<double>("vertices");  // seconds that those of a frame in full take
        QTest::addColumn<double>("pixels");    // likewise
        QTest::addColumn<float>("scale");
        QTest::addColumn<bool>("coarse");
        QTest::newRow("few of both") << 0.010 << 0.015 << 1.0f << false;
        QTest::newRow("many vertices") << 0.200 << 0.010 << 1.0f << true;
        QTest::newRow("many of both") << 0.200 << 0.100 << 0.5f << true;
        QTest::newRow("many pixels") << 0.002 << 0.060 << 0.70710678f << false;
    }
    static void trianglesGoFirst() {
        QFETCH(double, vertices);
        QFETCH(double, pixels);
        QFETCH(float, scale);
        QFETCH(bool, coarse);
        constexpr float kPart = 0.05f;
        MotionDetail motion;
        motion.setCoarsePart(kPart);
        for (int i = 0; i < 200; ++i) {
            const PictureDetail detail = motion.detail();
            motion.frameTook((detail.coarse ? static_cast<double>(kPart) : 1.0) * vertices +
                             static_cast<double>(detail.scale * detail.scale) * pixels);
            if (i >= 20) {
                QCOMPARE(motion.detail(), (PictureDetail{.scale = scale, .coarse = coarse}));
            }
        }
    }

    /// Nobody waits for three frames of half a second.
    static void aVerySlowFrameIsEnough() {
        MotionDetail motion;
        motion.setCoarsePart(0.05f);
        motion.frameTook(0.5);
        QVERIFY(motion.detail().coarse);
        MotionDetail plain;  // there is nothing to leave out
        plain.frameTook(0.5);
        QVERIFY(plain.detail().isFull());
    }

    static void allTrianglesComeBackWhereTheyAreFast() {
        MotionDetail motion;
        motion.setCoarsePart(0.5f);
        motion.frameTook(0.5);  // something else took the time
        motion.frameTook(0.012);
        for (int i = 0; i < 3; ++i) {
            QVERIFY(motion.detail().coarse);
            motion.frameTook(0.012);
        }
        QVERIFY(motion.detail().isFull());
    }

    /// One frame that takes long, as one that compiles a program does, is not enough.
    static void aSlowFrameAloneChangesNothing() {
        MotionDetail motion;
        motion.frameTook(0.060);
        QCOMPARE(moved(motion, 20, [](float) { return 0.010; }), 1.0f);
    }
};

HITSCOPE_TEST(MotionDetailTest, QCoreApplication)

}  // namespace hitscope::motion_detail_test

#include "motion_detail_test.moc"
