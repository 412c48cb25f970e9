// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace hitscope {

/// Files that belong together. Each is written in full and synced under a hidden name beside its place;
/// commit() then gives them their names in the order in which they were added, so that whoever refers to
/// another comes after it. A crash in between leaves what was there before; an error as well, without new
/// files.
class StagedFiles {
public:
    enum class Existing : std::uint8_t { Keep, Replace };  ///< Keep: commit() fails where a file has come

    /// `beforeStep` is called before each step that changes something on the disk; for tests.
    explicit StagedFiles(std::function<void()> beforeStep = {});
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Makes missing folders. `mode`: of a new file, before the umask; a file that is replaced keeps its own.
    [[nodiscard]] Status add(const QString& path, std::string_view content, Existing existing,
                             unsigned mode = 0666);
    /// What `write` writes; on false errno has the reason.
    [[nodiscard]] Status add(const QString& path, const std::function<bool(int descriptor)>& write,
                             Existing existing = Existing::Replace);
    /// Copies a regular file of `most` bytes at most in pieces, with its mode; it does not follow a link.
    [[nodiscard]] Status addCopy(const QString& source, const QString& path, qint64 most);
    /// Whether commit() will bring a file there.
    [[nodiscard]] bool holds(const QString& path) const;
    /// A line for people that names all files but `path`, from its folder; none where that is all. After
    /// commit().
    [[nodiscard]] QStringList noteOfOthers(const QString& path) const;

    [[nodiscard]] Status commit();

private:
    struct File {
        QString path;
        QByteArray temporary;
        Existing existing;
    };
    Status fill(const QString& path, Existing existing, unsigned mode,
                const std::function<bool(int descriptor)>& write);
    [[nodiscard]] bool makeFolder(const QString& path);
    void step() const;
    void removeNew(std::size_t named);

    std::function<void()> m_beforeStep;
    std::vector<File> m_files;
    std::vector<QString> m_newFolders;
    bool m_isDone = false;
};

/// Writes a file, whole or not at all; the error has the system's reason ("No space left on device"). Devices
/// and pipes are written as they are.
[[nodiscard]] Status writeWhole(const QString& path, std::string_view content);

/// The same for content that comes in pieces: `make` gives each to its argument, and ends when that says
/// false.
using PutPiece = std::function<bool(std::string_view piece)>;
[[nodiscard]] Status writeWhole(const QString& path, const std::function<void(const PutPiece&)>& make);

/// Whether both are files of the same bytes; read in pieces.
[[nodiscard]] bool haveSameContent(const QString& a, const QString& b);

}  // namespace hitscope
