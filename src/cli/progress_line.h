// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace hitscope::cli {

/// A line on the standard error that says how far something is, where that is a terminal and the program is
/// not quiet, once it has taken half a second; it is gone afterwards.
class ProgressLine {
public:
    /// "Drawing", 120: shown as "Drawing: 7 of 120".
    ProgressLine(const QString& doing, int count);
    /// "Refining": shown as "Refining: 7 %", of 100.
    explicit ProgressLine(const QString& doing) : ProgressLine(doing, kPercent) {}
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(int done);
    void hide();  ///< for what else is said meanwhile

private:
    static constexpr int kPercent = -1;

    QString m_doing;
    int m_count;
    bool m_isWanted;
    qsizetype m_shown = 0;  ///< characters
    QElapsedTimer m_begun;
    QElapsedTimer m_since;  ///< it was shown
};

/// The same for what does not say how far it is: "Applying hits: 3 s", from a thread of its own. Within
/// another one it shows nothing.
class WaitingLine {
public:
    explicit WaitingLine(const QString& doing);
    ~WaitingLine();
    WaitingLine(const WaitingLine&) = delete;
    WaitingLine& operator=(const WaitingLine&) = delete;

    /// Of the one that is there, if any: for what else is said meanwhile. It comes again.
    static void hide();

private:
    void run();
    void clear();  ///< with the mutex

    QString m_doing;
    std::mutex m_mutex;
    std::condition_variable m_over;
    bool m_isOver = false;
    qsizetype m_shown = 0;  ///< characters
    std::thread m_thread;   ///< none: nothing is shown
};

}  // namespace hitscope::cli
