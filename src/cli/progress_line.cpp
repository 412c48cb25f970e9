// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress_line.h"

#include <unistd.h>

#include <QTextStream>
#include <cstdio>

#include "cli/command_line.h"

namespace hitscope::cli {

ProgressLine::ProgressLine(const QString& doing, int count)
    : m_doing(doing), m_count(count), m_isWanted(!isQuiet() && ::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
    hide();
}

void ProgressLine::show(int done) {
    constexpr qint64 kBetween = 100;  // milliseconds: more often nobody reads it
    const bool isLast = m_count != kPercent && done >= m_count;
    if (!m_isWanted || (m_since.isValid() && m_since.elapsed() < kBetween && !isLast)) {
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

}  // namespace hitscope::cli
