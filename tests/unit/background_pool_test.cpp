// SPDX-License-Identifier: GPL-3.0-or-later
// Work beside the window leaves the threads alone that Qt paints with.
#include <QObject>
#include <QSemaphore>
#include <QTest>
#include <QThreadPool>

#include "analysis/beside.h"
#include "support/test_program.h"

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

namespace hitscope::background_pool_test {

#ifdef Q_OS_LINUX
namespace {

constexpr int kNiceness = 10;  // of background work

}  // namespace
#endif

class BackgroundPoolTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void isNotThePoolThatPaintingWaitsFor() {
        const int jobs = QThreadPool::globalInstance()->maxThreadCount() + 1;
        QSemaphore begun;
        QSemaphore mayEnd;
        int told = 0;
        for (int i = 0; i < jobs; ++i) {
            workBeside(
                this,
                [&] {
                    begun.release();
                    mayEnd.acquire();
                },
                [&told](BackgroundPoolTest& /*owner*/, bool done) { told += done ? 1 : 0; });
        }
        begun.acquire();
        const int threadsTaken = QThreadPool::globalInstance()->activeThreadCount();
        mayEnd.release(jobs);
        QTRY_COMPARE(told, jobs);
        QCOMPARE(threadsTaken, 0);
    }

#ifdef Q_OS_LINUX
    void givesWay() {
        const int here = getpriority(PRIO_PROCESS, 0);
        int there = here;
        bool isTold = false;
        workBeside(
            this, [&there] { there = getpriority(PRIO_PROCESS, 0); },
            [&isTold](BackgroundPoolTest& /*owner*/, bool /*done*/) { isTold = true; });
        QTRY_VERIFY(isTold);
        QVERIFY2(there > here || here >= kNiceness, qPrintable(QString::number(there)));
        QCOMPARE(getpriority(PRIO_PROCESS, 0), here);
    }
#endif
};

HITSCOPE_TEST(BackgroundPoolTest, QCoreApplication)

}  // namespace hitscope::background_pool_test

#include "background_pool_test.moc"
