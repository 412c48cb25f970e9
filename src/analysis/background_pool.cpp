// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/background_pool.h"

#include <QCoreApplication>
#include <QThreadPool>
#include <utility>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

namespace hitscope {

namespace {

/// Threads have a share of a processor by this: next to one that does not give way, a tenth of it.
[[maybe_unused]] constexpr int kNiceness = 10;

}  // namespace

void giveWay() {
#ifdef Q_OS_LINUX
    // Of this thread, and of those that it starts. The whole program may give way by more already.
    thread_local const bool gives =
        getpriority(PRIO_PROCESS, 0) >= kNiceness || setpriority(PRIO_PROCESS, 0, kNiceness) == 0;
    Q_UNUSED(gives)
#endif
}

QThreadPool& backgroundPool() {
    static QThreadPool pool;
    [[maybe_unused]] static const bool isWaitedFor = [] {
        qAddPostRoutine([] { backgroundPool().waitForDone(); });
        return true;
    }();
    return pool;
}

void startInBackground(std::function<void()> job) {
    backgroundPool().start([job = std::move(job)] {
        giveWay();
        job();
    });
}

}  // namespace hitscope
