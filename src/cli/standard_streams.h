// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <string_view>

#include "core/result.h"

namespace hitscope::cli {

/// What stands for the standard input or output in place of a file's name: "-".
[[nodiscard]] inline bool isStandardStream(const QString& path) {
    return path == QLatin1String("-");
}

/// All of a file, or of the standard input, `most` bytes at most.
[[nodiscard]] Result<QByteArray> readAllOf(const QString& path, qint64 most);
/// Into a file, whole or not at all, or to the standard output.
[[nodiscard]] Status writeAllTo(const QString& path, std::string_view bytes);

/// A folder below the system's for temporary files, which goes with this, or when the program is ended.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] Status check() const;  ///< whether it could be made
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] QString file(const QString& name) const { return m_path + u'/' + name; }
    /// What is in it, but for that file.
    [[nodiscard]] QStringList filesBeside(const QString& path) const;

private:
    QString m_path;
};

}  // namespace hitscope::cli
