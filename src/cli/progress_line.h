// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>

namespace hitscope::cli {

/// A line on the standard error that says how far something is, where that is a terminal and the program is
/// not quiet; it is gone afterwards.
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
    QElapsedTimer m_since;  ///< it was shown
};

}  // namespace hitscope::cli
