// SPDX-License-Identifier: GPL-3.0-or-later
// When a picture is drawn with less detail, and when it is left to the refiner.
#include "viewport/picture_motion.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "support/test_program.h"

namespace hitscope::picture_motion_test {

namespace {

constexpr float kPart = 0.05f;  // of the triangles, in coarse pictures
constexpr int kPatience = 5000;

/// A frame that takes so long; how it was drawn.
PictureDetail drawn(PictureMotion& motion, double seconds) {
    const PictureDetail detail = motion.beginFrame();
    motion.frameShown(seconds);
    return detail;
}

}  // namespace

class PictureMotionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    static void aJumpIsDrawnInFull() {
        PictureMotion motion;
        motion.setOn(true);
        motion.hold(PictureDetail{.scale = 0.5f});
        motion.moved();
        QVERIFY(drawn(motion, 0.05).isFull());
        QCOMPARE(drawn(motion, 0.05).scale, 0.5f);
        const QSignalSpy rested(&motion, &PictureMotion::rested);
        QVERIFY(motion.isReduced());
        QTRY_COMPARE_WITH_TIMEOUT(rested.size(), 1, kPatience);
        QVERIFY(drawn(motion, 0.05).isFull());
        QVERIFY(!motion.isReduced());
    }

    static void whatIsHeldTeachesNothing() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setCoarsePart(kPart);
        motion.hold(PictureDetail());
        motion.moved();
        for (int i = 0; i < 20; ++i) {
            QVERIFY(drawn(motion, 0.5).isFull());
        }
        motion.hold(std::nullopt);
        QVERIFY(drawn(motion, 0.5).isFull());
        QVERIFY(drawn(motion, 0.03).coarse);
    }

    /// Its frames are coarse from the first, so that only their pixels are judged.
    static void whatIsSlowLosesPixelsAtOnce() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setRefined(true);
        motion.setCoarsePart(kPart, true);
        motion.moved();
        for (int i = 0; i < 4; ++i) {
            const PictureDetail detail = drawn(motion, 0.09);
            QVERIFY(detail.coarse && detail.scale == 1.0f);
        }
        QCOMPARE(motion.coming().scale, 0.5f);
    }

    /// Not one that is being drawn, which may turn out to be another.
    static void tellsWhatIsSeen() {
        PictureMotion motion;
        motion.setOn(true);
        motion.hold(PictureDetail{.scale = 0.5f});
        motion.moved();
        QVERIFY(drawn(motion, 0.05).isFull());
        QCOMPARE(motion.beginFrame().scale, 0.5f);
        QVERIFY(motion.seenDetail().isFull());
        motion.keptShown(false);
        motion.frameShown(0.05);
        QVERIFY(motion.seenDetail().isFull());
        QCOMPARE(drawn(motion, 0.05).scale, 0.5f);
        QCOMPARE(motion.seenDetail().scale, 0.5f);
    }

    static void whatIsSlowIsLeftToTheRefiner() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setRefined(true);
        motion.setCoarsePart(kPart);
        QVERIFY(drawn(motion, 0.5).isFull());  // it may have built programs
        QVERIFY(drawn(motion, 0.5).isFull());
        QVERIFY(drawn(motion, 0.03).coarse);
        motion.moved();
        QVERIFY(drawn(motion, 0.03).coarse);  // the first of a motion too
        // Nothing is asked for when it rests: the refiner comes.
        const QSignalSpy rested(&motion, &PictureMotion::rested);
        QTest::qWait(3 * PictureMotion::kRest);
        QCOMPARE(rested.size(), 0);
        QVERIFY(!motion.isReduced());
        QVERIFY(motion.beginFrame().coarse);
        motion.keptShown(false);
        motion.frameShown(0.001);  // which says nothing of a frame that is drawn
        QVERIFY(motion.lastDetail().isFull());
        QVERIFY(drawn(motion, 0.03).coarse);
        motion.forget();
        QCOMPARE(rested.size(), 1);  // now nobody else draws it in full
        QVERIFY(drawn(motion, 0.03).isFull());
    }

    static void whatKeepsEventsWaitingIsLeftToTheRefiner() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setRefined(true);
        motion.setCoarsePart(kPart);
        motion.setSlow(0.1, 0.04);
        const auto isCoarse = [&motion](double waiting) {
            const bool coarse = motion.beginFrame().coarse;
            motion.drawn(coarse, waiting);
            motion.frameShown(0.09);
            return coarse;
        };
        QVERIFY(!isCoarse(0.05));  // it may have built programs
        QVERIFY(!isCoarse(0.03));
        QVERIFY(!isCoarse(0.05));  // something may have held it up
        QVERIFY(!isCoarse(0.03));
        QVERIFY(!isCoarse(0.05));
        QVERIFY(!isCoarse(0.05));
        QVERIFY(isCoarse(0.003));
        QVERIFY(isCoarse(0.003));
        motion.forget();
        QVERIFY(!isCoarse(0.03));
        QVERIFY(!isCoarse(0.07));  // far too long
        QVERIFY(isCoarse(0.003));
    }

    static void besideOtherWorkThePictureIsLeftToTheRefiner() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setCoarsePart(kPart);
        motion.setBusy(true);
        QVERIFY(drawn(motion, 0.03).isFull());  // nobody else would draw it
        motion.setRefined(true);
        QVERIFY(drawn(motion, 0.03).coarse);
        QVERIFY(!motion.isReduced());
        const QSignalSpy rested(&motion, &PictureMotion::rested);
        motion.setBusy(false);
        QCOMPARE(rested.size(), 1);
        QVERIFY(drawn(motion, 0.03).isFull());
        motion.setBusy(true);
        motion.setBusy(false);
        QCOMPARE(rested.size(), 1);  // nothing was drawn meanwhile
    }

    static void fewerPixelsAreTriedAgainFromCloseBy() {
        PictureMotion motion;
        motion.setOn(true);
        motion.seenFrom(10.0f);
        motion.moved();
        for (int i = 0; i < 20; ++i) {
            drawn(motion, 0.1);
        }
        const auto move = [&motion](float distance) {
            float scale = 1.0f;
            for (int i = 0; i < 20; ++i) {
                motion.seenFrom(distance);
                motion.moved();
                scale = motion.coming().scale;
                drawn(motion, 0.1 * static_cast<double>(scale * scale));
            }
            return scale;
        };
        QCOMPARE(move(8.0f), 1.0f);  // it was no help
        QCOMPARE(move(4.0f), 0.5f);
    }

    static void whatIsInAHurryHasHalfOfThePixels() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setCoarsePart(0.5f, true);
        motion.setCatchingUp(true);
        motion.moved();
        QCOMPARE(motion.coming().scale, 1.0f);  // nobody else would draw it in full
        motion.setRefined(true);
        for (int i = 0; i < 12; ++i) {
            const PictureDetail detail = drawn(motion, 0.2);
            QVERIFY(detail.coarse);
            QVERIFY2(std::abs(detail.scale * detail.scale - 0.5f) < 1e-6f,
                     qPrintable(QString::number(detail.scale)));
        }
        motion.setCatchingUp(false);
        QCOMPARE(motion.coming().scale, 1.0f);  // nothing was learnt from them
        QVERIFY(motion.isReduced());
        motion.setCatchingUp(true);
        motion.hold(PictureDetail());
        QCOMPARE(motion.coming().scale, 1.0f);
    }

    static void whatWillBeSlowIsCoarseFromTheFirst() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setRefined(true);
        motion.setCoarsePart(0.5f, true);
        QVERIFY(drawn(motion, 0.5).coarse);
        motion.forget();  // another size, for one, of the same scene
        QVERIFY(drawn(motion, 0.06).coarse);
        QVERIFY(drawn(motion, 0.04).coarse);
        QVERIFY(drawn(motion, 0.04).isFull());  // it was not slow after all
        motion.setCoarsePart(1.0f, true);
        QVERIFY(drawn(motion, 0.5).isFull());
        QVERIFY(drawn(motion, 0.5).isFull());
    }

    static void whatIsFastOrCannotBeRefinedIsNot_data() {
        QTest::addColumn<bool>("on");
        QTest::addColumn<bool>("refined");
        QTest::addColumn<float>("part");
        QTest::addColumn<double>("seconds");
        QTest::newRow("fast") << true << true << kPart << 0.09;
        QTest::newRow("no refiner") << true << false << kPart << 0.5;
        QTest::newRow("few triangles") << true << true << 1.0f << 0.5;
        QTest::newRow("turned off") << false << true << kPart << 0.5;
    }
    static void whatIsFastOrCannotBeRefinedIsNot() {
        QFETCH(bool, on);
        QFETCH(bool, refined);
        QFETCH(float, part);
        QFETCH(double, seconds);
        PictureMotion motion;
        motion.setOn(on);
        motion.setRefined(refined);
        motion.setCoarsePart(part);
        for (int i = 0; i < 4; ++i) {
            QVERIFY(drawn(motion, seconds).isFull());
        }
    }

    /// Something else took the time.
    static void fastCoarseFramesBringItBack() {
        PictureMotion motion;
        motion.setOn(true);
        motion.setRefined(true);
        motion.setCoarsePart(0.5f);
        drawn(motion, 0.5);
        drawn(motion, 0.5);
        const QSignalSpy rested(&motion, &PictureMotion::rested);
        QVERIFY(drawn(motion, 0.06).coarse);  // all could take twice as long
        QCOMPARE(rested.size(), 0);
        QVERIFY(drawn(motion, 0.04).coarse);
        QCOMPARE(rested.size(), 1);
        QVERIFY(drawn(motion, 0.04).isFull());
    }
};

HITSCOPE_TEST(PictureMotionTest, QCoreApplication)

}  // namespace hitscope::picture_motion_test

#include "picture_motion_test.moc"
