// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/loop_watch.h"

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>
#include <chrono>
#include <utility>

namespace hitscope::bench {

namespace {

constexpr std::chrono::milliseconds kBetween(1);
constexpr double kSecond = 1.0e9;  // nanoseconds

}  // namespace

std::int64_t nowInNanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

LoopWatch::LoopWatch(std::function<void()> seen) : m_seen(std::move(seen)), m_thread([this] { post(); }) {}

LoopWatch::~LoopWatch() {
    m_ends = true;
    m_thread.join();
}

void LoopWatch::post() {
    while (!m_ends) {
        if (m_sent == 0) {
            m_sent = nowInNanoseconds();
            QCoreApplication::postEvent(this, new QEvent(QEvent::User));
        }
        std::this_thread::sleep_for(kBetween);
    }
}

double LoopWatch::longest() const {
    const std::int64_t sent = m_sent;
    const std::int64_t waiting = sent == 0 ? 0 : nowInNanoseconds() - sent;
    return static_cast<double>(std::max(m_longest, waiting)) / kSecond;
}

bool LoopWatch::event(QEvent* event) {
    if (event->type() != QEvent::User) {
        return QObject::event(event);
    }
    m_longest = std::max(m_longest, nowInNanoseconds() - m_sent);
    m_sent = 0;
    m_seen();
    return true;
}

}  // namespace hitscope::bench
