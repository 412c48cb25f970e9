// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <memory>
#include <vector>

#include "core/result.h"

namespace hitscope {

/// Where journals are: hitscope/journals in XDG_STATE_HOME, or in ~/.local/state.
[[nodiscard]] QString journalFolder();

/// A journal that a process left behind that did not end in order.
struct FoundJournal {
    QString path;
    QDateTime changed;  ///< for the last time
    qint64 bytes = 0;
};
/// Those of a folder that no process has open, newest first. Clears away what a process left that ended while
/// it began one.
[[nodiscard]] std::vector<FoundJournal> findJournals(const QString& folder);

/// A journal that was left behind, kept for this process alone: as long as this lives, no other finds it.
class ClaimedJournal {
public:
    /// Fails where it is gone, or another process has it.
    [[nodiscard]] static Result<ClaimedJournal> claim(const QString& path);
    ~ClaimedJournal();
    ClaimedJournal(ClaimedJournal&& other) noexcept;
    ClaimedJournal& operator=(ClaimedJournal&& other) noexcept;
    ClaimedJournal(const ClaimedJournal&) = delete;
    ClaimedJournal& operator=(const ClaimedJournal&) = delete;

    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] Result<QByteArray> read() const;  ///< on any thread
    [[nodiscard]] Status discard();                 ///< takes it away for good
    /// Renames it, so that nobody finds it as a journal any more; path() is the new one.
    [[nodiscard]] Status setAside();

private:
    ClaimedJournal(QString path, int descriptor) : m_path(std::move(path)), m_descriptor(descriptor) {}

    QString m_path;
    int m_descriptor = -1;
};

}  // namespace hitscope
