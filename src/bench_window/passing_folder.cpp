// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/passing_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <QFile>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <thread>

#include "io/pending_files.h"

namespace hitscope::bench {

namespace {

std::array<int, 2> ends{-1, -1};  // of a pipe: a signal's number goes through it to a thread

extern "C" void tellThread(int signal) {
    const int before = errno;
    const auto number = static_cast<std::uint8_t>(signal);
    [[maybe_unused]] const ssize_t written = ::write(ends[1], &number, 1);
    errno = before;
}

void waitForTheEnd() {
    std::uint8_t number = 0;
    while (::read(ends[0], &number, 1) != 1) {
        if (errno != EINTR) {
            return;
        }
    }
    removePendingFiles();
    std::signal(number, SIG_DFL);
    ::kill(::getpid(), number);
}

}  // namespace

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
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        return;
    }
    std::thread(waitForTheEnd).detach();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) {
            now.sa_handler = tellThread;
            now.sa_flags = SA_RESTART;  // and stays: a command that ends sends more than one
            ::sigaction(signal, &now, nullptr);
        }
    }
}

}  // namespace hitscope::bench
