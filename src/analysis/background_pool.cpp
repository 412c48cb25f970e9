// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/background_pool.h"

#include <QCoreApplication>
#include <QThreadPool>

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace hitscope {

namespace {

[[maybe_unused]] constexpr int kBehindTheWindow =
    5;  // niceness: a quarter of the processor where both want it

}  // namespace

QThreadPool& backgroundPool() {
    static QThreadPool pool;
    [[maybe_unused]] static const bool isWaitedFor = [] {
        qAddPostRoutine([] { backgroundPool().waitForDone(); });
        return true;
    }();
    return pool;
}

void yieldToTheWindow() {
#ifdef __linux__
    // Of this thread alone, and of those that it starts.
    thread_local const bool isBehind = [] {
        const auto thread = static_cast<id_t>(syscall(SYS_gettid));
        return getpriority(PRIO_PROCESS, thread) >= kBehindTheWindow ||
               setpriority(PRIO_PROCESS, thread, kBehindTheWindow) == 0;
    }();
    static_cast<void>(isBehind);
#endif
}

}  // namespace hitscope
