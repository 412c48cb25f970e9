// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/passing_folder.h"

#include <QFile>
#include <csignal>
#include <cstdlib>

#include "io/pending_files.h"

namespace hitscope::bench {

PassingFolder::PassingFolder() {
    if (m_folder.isValid()) {
        notePending(QFile::encodeName(m_folder.path()));
    }
}

PassingFolder::~PassingFolder() {
    if (m_folder.isValid()) {
        const QByteArray path = QFile::encodeName(m_folder.path());
        m_folder.remove();
        forgetPending(path);
    }
}

// Where the command is ended, the display in memory goes too, and Qt ends the program for that.
void leaveNothingBehind() {
    std::atexit(removePendingFiles);
    std::signal(SIGPIPE, SIG_IGN);  // nobody reads any more what Qt says of the display then
    removePendingFilesAt({SIGINT, SIGTERM, SIGHUP});
}

}  // namespace hitscope::bench
