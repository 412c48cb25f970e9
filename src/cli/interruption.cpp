// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interruption.h"

#include <csignal>

#include "io/pending_files.h"

namespace hitscope::cli {

void endInOrder() {
    removePendingFilesAt({SIGINT, SIGTERM, SIGHUP, SIGPIPE});
}

}  // namespace hitscope::cli
