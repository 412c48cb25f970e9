// SPDX-License-Identifier: GPL-3.0-or-later
// Work beside the window leaves the threads alone that Qt paints with.
#include <QObject>
#include <QSemaphore>
#include <QTest>
#include <QThreadPool>

#include "analysis/beside.h"
#include "support/test_program.h"

namespace hitscope::background_pool_test {

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
};

HITSCOPE_TEST(BackgroundPoolTest, QCoreApplication)

}  // namespace hitscope::background_pool_test

#include "background_pool_test.moc"
