// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string_view>

#include "core/result.h"
#include "document/journal_records.h"

namespace hitscope {

/// The file of one journal, open and locked. What fails leaves it good up to what was written before. Its
/// functions wait for the disk.
class JournalFile {
public:
    /// A name of its own in `folder`, which is made where it is missing by begin().
    explicit JournalFile(const QString& folder);
    ~JournalFile();  ///< leaves the file
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;

    /// Takes the place of what is there in one step, synced.
    [[nodiscard]] Status begin(const SessionDocument& document);
    [[nodiscard]] Status append(std::string_view text);  ///< after begin()
    [[nodiscard]] Status sync();
    void remove();

    [[nodiscard]] bool isOpen() const { return m_descriptor >= 0; }
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] JournalLines& lines() { return m_lines; }
    /// That the changes take much more room than the session would.
    [[nodiscard]] bool isLarge() const;

private:
    void take(int descriptor, std::size_t bytes);

    QString m_folder;
    QString m_path;
    JournalLines m_lines;
    int m_descriptor = -1;
    std::size_t m_bytes = 0;
    std::size_t m_snapshotBytes = 0;
};

}  // namespace hitscope
