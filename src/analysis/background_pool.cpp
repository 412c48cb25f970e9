// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/background_pool.h"

#include <QCoreApplication>
#include <QThreadPool>

namespace hitscope {

QThreadPool& backgroundPool() {
    static QThreadPool pool;
    [[maybe_unused]] static const bool isWaitedFor = [] {
        qAddPostRoutine([] { backgroundPool().waitForDone(); });
        return true;
    }();
    return pool;
}

}  // namespace hitscope
