// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/end_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <cerrno>
#include <csignal>

namespace hitscope {

namespace {

constexpr int kSignals[] = {SIGTERM, SIGINT, SIGHUP};

int pipeEnds[2] = {-1, -1};  // a handler may write to a pipe, and do little else

extern "C" void passOn(int signal) {
    const int before = errno;
    const char byte = static_cast<char>(signal);
    if (::write(pipeEnds[1], &byte, 1) != 1) {  // cannot happen: the pipe takes thousands
        ::_exit(128 + signal);
    }
    errno = before;
}

}  // namespace

EndSignals::EndSignals(QObject* parent) : QObject(parent) {
    if (::pipe2(pipeEnds, O_CLOEXEC | O_NONBLOCK) != 0) {
        return;
    }
    auto* notifier = new QSocketNotifier(pipeEnds[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, &EndSignals::read);
    for (const int signal : kSignals) {
        struct sigaction action {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN) {  // nohup
            continue;
        }
        action = {};
        action.sa_handler = passOn;
        action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
        ::sigaction(signal, &action, nullptr);
    }
}

EndSignals::~EndSignals() {
    for (const int signal : kSignals) {
        struct sigaction action {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler == passOn) {
            std::signal(signal, SIG_DFL);
        }
    }
    for (int& end : pipeEnds) {
        ::close(end);
        end = -1;
    }
}

void EndSignals::read() {
    char byte = 0;
    if (::read(pipeEnds[0], &byte, 1) == 1) {
        Q_EMIT caught(byte);
    }
}

}  // namespace hitscope
