// SPDX-License-Identifier: GPL-3.0-or-later
// Which turns of the event loop slices, preparations and pictures take.
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "support/test_program.h"
#include "viewport/catch_up.h"

namespace hitscope::catch_up_test {

class CatchUpTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSliceLeavesTheTurnAfterAPictureToEvents() {
        CatchUp catchUp;
        const QSignalSpy slices(&catchUp, &CatchUp::sliceDue);
        catchUp.pictureShown();
        catchUp.sliceLater();
        aTurnOfTimers();
        QCOMPARE(slices.size(), 0);
        QVERIFY(catchUp.isSliceComing());
        QTRY_COMPARE(slices.size(), 1);
    }

    void slicesFollowOneAnotherAtOnce() {
        CatchUp catchUp;
        const QSignalSpy slices(&catchUp, &CatchUp::sliceDue);
        catchUp.sliceLater();
        aTurnOfTimers();
        QCOMPARE(slices.size(), 1);
    }

    void thereAreTwoPicturesASecond() {
        CatchUp catchUp;
        QVERIFY(!catchUp.isPictureDue(false));  // nothing new to see
        catchUp.wantPicture();
        QVERIFY(catchUp.isPictureDue(false));
        catchUp.pictureShown();
        catchUp.wantPicture();
        QVERIFY(!catchUp.isPictureDue(false));
        QVERIFY(catchUp.isPictureDue(true));
        QTRY_VERIFY(catchUp.isPictureDue(false));
    }

private:
    /// Until the timers that were started before have been seen to once.
    static void aTurnOfTimers() {
        QTimer last;
        const QSignalSpy seen(&last, &QTimer::timeout);
        last.setSingleShot(true);
        last.start(0);
        while (seen.isEmpty()) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
    }
};

HITSCOPE_TEST(CatchUpTest, QCoreApplication)

}  // namespace hitscope::catch_up_test

#include "catch_up_test.moc"
