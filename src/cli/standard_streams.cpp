// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/standard_streams.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>

#include "io/pending_files.h"
#include "io/staged_files.h"

namespace hitscope::cli {

Result<QByteArray> readAllOf(const QString& path, qint64 most) {
    QFile file(path);
    QByteArray bytes;
    std::string name = "standard input";
    if (isStandardStream(path)) {
        constexpr qsizetype kPiece = 1 << 16;
        QByteArray piece(kPiece, Qt::Uninitialized);
        while (bytes.size() <= most && std::feof(stdin) == 0 && std::ferror(stdin) == 0) {
            const std::size_t read = std::fread(piece.data(), 1, static_cast<std::size_t>(kPiece), stdin);
            bytes.append(piece.constData(), static_cast<qsizetype>(read));
        }
    } else if (QFileInfo(path).isDir() || !file.open(QIODevice::ReadOnly)) {
        return Error{QFileInfo::exists(path) ? "The file cannot be read." : "There is no such file.",
                     path.toStdString(), ""};
    } else {
        name = path.toStdString();
        bytes = file.size() > 0 ? file.read(std::min(most + 1, file.size()))
                                : file.readAll();  // a pipe has no size
    }
    if (bytes.size() > most) {
        return Error{"It has more than " + std::to_string(most >> 20) + " MB.", name, ""};
    }
    return bytes;
}

Status writeAllTo(const QString& path, std::string_view bytes) {
    if (!isStandardStream(path)) {
        return writeWhole(path, bytes);
    }
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);  // flushOutput() tells of errors
    return Done{};
}

ScratchFolder::ScratchFolder() {
    QTemporaryDir folder(QDir::temp().filePath(QStringLiteral("hitscope-XXXXXX")));
    if (folder.isValid()) {
        m_path = folder.path();
        notePending(QFile::encodeName(m_path));
        folder.setAutoRemove(false);
    }
}

ScratchFolder::~ScratchFolder() {
    if (!m_path.isEmpty()) {
        QDir(m_path).removeRecursively();
        forgetPending(QFile::encodeName(m_path));
    }
}

QStringList ScratchFolder::filesBeside(const QString& path) const {
    QStringList names = QDir(m_path).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
    names.removeAll(QFileInfo(path).fileName());
    return names;
}

Status ScratchFolder::check() const {
    return m_path.isEmpty()
               ? Status(Error{"No folder for temporary files can be made.", QDir::tempPath().toStdString(),
                              "Set TMPDIR to one you may write to."})
               : Status(Done{});
}

}  // namespace hitscope::cli
