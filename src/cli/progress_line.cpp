// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress_line.h"

#include <unistd.h>

#include <QTextStream>
#include <chrono>
#include <cstdio>
#include <system_error>

#include "cli/command_line.h"

namespace hitscope::cli {

namespace {

constexpr std::chrono::milliseconds kPatience(500);  // what is over sooner needs no line

WaitingLine* waiting = nullptr;  // of the main thread

bool isProgressWanted() {
    return !isQuiet() && ::isatty(STDERR_FILENO) != 0;
}

}  // namespace

ProgressLine::ProgressLine(const QString& doing, int count)
    : m_doing(doing), m_count(count), m_isWanted(isProgressWanted()) {
    m_begun.start();
}

ProgressLine::~ProgressLine() {
    hide();
}

void ProgressLine::show(int done) {
    constexpr qint64 kBetween = 100;  // milliseconds: more often nobody reads it
    const bool isLast = m_count != kPercent && done >= m_count;
    const bool isEarly = m_begun.elapsed() < kPatience.count();
    if (!m_isWanted || isEarly || (m_since.isValid() && m_since.elapsed() < kBetween && !isLast)) {
        return;
    }
    m_since.start();
    const QString line = m_count == kPercent
                             ? QStringLiteral("%1: %2 %").arg(m_doing).arg(done)
                             : QStringLiteral("%1: %2 of %3").arg(m_doing).arg(done).arg(m_count);
    QTextStream(stderr) << '\r' << line.leftJustified(m_shown);
    m_shown = line.size();
}

void ProgressLine::hide() {
    if (m_shown > 0) {
        QTextStream(stderr) << '\r' << QString(m_shown, u' ') << '\r';
        m_shown = 0;
    }
}

WaitingLine::WaitingLine(const QString& doing) : m_doing(doing) {
    if (waiting != nullptr || !isProgressWanted()) {
        return;
    }
    try {
        m_thread = std::thread(&WaitingLine::run, this);
        waiting = this;
    } catch (const std::system_error&) {
        // There is no thread to be had, and no line then.
    }
}

WaitingLine::~WaitingLine() {
    if (!m_thread.joinable()) {
        return;
    }
    {
        const std::scoped_lock lock(m_mutex);
        m_isOver = true;
    }
    m_over.notify_one();
    m_thread.join();
    clear();
    waiting = nullptr;
}

void WaitingLine::run() {
    const auto begun = std::chrono::steady_clock::now();
    std::unique_lock lock(m_mutex);
    std::chrono::milliseconds next = kPatience;
    while (!m_over.wait_until(lock, begun + next, [this] { return m_isOver; })) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(next);
        const QString line = seconds.count() == 0
                                 ? m_doing + QStringLiteral(" ...")
                                 : QStringLiteral("%1: %2 s").arg(m_doing).arg(seconds.count());
        QTextStream(stderr) << '\r' << line.leftJustified(m_shown);
        m_shown = line.size();
        next = seconds + std::chrono::seconds(1);
    }
}

void WaitingLine::clear() {
    if (m_shown > 0) {
        QTextStream(stderr) << '\r' << QString(m_shown, u' ') << '\r';
        m_shown = 0;
    }
}

void WaitingLine::hide() {
    if (waiting != nullptr) {
        const std::scoped_lock lock(waiting->m_mutex);
        waiting->clear();
    }
}

}  // namespace hitscope::cli
