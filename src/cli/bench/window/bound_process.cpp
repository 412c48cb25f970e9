// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/window/bound_process.h"

#ifdef Q_OS_LINUX
#include <sys/prctl.h>

#include <csignal>
#endif

namespace hitscope::bench {

void bindToThis(QProcess& process) {
#ifdef Q_OS_LINUX
    process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGTERM); });
#else
    Q_UNUSED(process)
#endif
}

}  // namespace hitscope::bench
