// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interruption.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <thread>

#include "io/pending_files.h"

namespace hitscope::cli {

namespace {

std::array<int, 2> ends{-1,
                        -1};  // of a pipe: a signal's number goes through it to a thread that may do anything

void tell(int signal) {
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

void endInOrder() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        return;
    }
    std::thread(waitForTheEnd).detach();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        struct sigaction now {};
        if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) {
            now.sa_handler = tell;
            now.sa_flags = SA_RESTART;
            ::sigaction(signal, &now, nullptr);
        }
    }
}

}  // namespace hitscope::cli
