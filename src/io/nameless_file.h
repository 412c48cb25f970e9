// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>

namespace hitscope {

/// A file in the folder for temporary files that has no name there: it is gone with the process, however that
/// ends.
class NamelessFile {
public:
    NamelessFile();
    ~NamelessFile();
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;

    [[nodiscard]] bool isOpen() const { return m_descriptor >= 0; }
    /// The system's reason where it could not be made.
    [[nodiscard]] const QString& whyNot() const { return m_whyNot; }
    /// By which this process, and others of the same person, open it once more, as long as this lives.
    [[nodiscard]] QString path() const;
    /// To hand it to a child process; negative: it is not open.
    [[nodiscard]] int descriptor() const { return m_descriptor; }
    /// Bytes; 0 too where that cannot be told.
    [[nodiscard]] std::uint64_t size() const;
    /// Gives its room on the disk back.
    void close();

private:
    int m_descriptor = -1;
    QString m_whyNot;
};

}  // namespace hitscope
