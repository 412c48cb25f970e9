// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/journal_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QRandomGenerator>
#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "document/journal_writer.h"

namespace hitscope {

namespace {

constexpr std::size_t kRoom = std::size_t{16} << 20;  // bytes of changes that are never many
constexpr std::size_t kManyTimes = 4;                 // the snapshot's size

Error cannot(const QString& path, int reason) {
    return {"Your work cannot be kept safe against a crash: " + qt_error_string(reason).toStdString() + ".",
            path.toStdString(), "Save the session yourself, and see that this folder can be written to."};
}

bool writeAll(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return true;
}

bool syncData(int descriptor) {
    return ::fdatasync(descriptor) == 0 || errno == EINVAL ||
           errno == EROFS;  // some file systems have no sync
}

/// So that the file's name is on the disk as well.
void syncFolder(const QString& folder) {
    const int descriptor = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

}  // namespace

JournalFile::JournalFile(const QString& folder)
    : m_folder(folder),
      m_path(
          QStringLiteral("%1/%2-%3-%4%5")
              .arg(folder, QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-hhmmss")),
                   QString::number(QCoreApplication::applicationPid()),
                   QStringLiteral("%1").arg(QRandomGenerator::system()->generate(), 8, 16, QLatin1Char('0')),
                   JournalWriter::kSuffix)) {}

JournalFile::~JournalFile() {
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
    }
}

Status JournalFile::begin(const SessionDocument& document) {
    errno = 0;
    if (!QDir().mkpath(m_folder)) {
        return cannot(m_folder, errno != 0 ? errno : ENOTDIR);
    }
    QString stem = m_path;
    stem.chop(JournalWriter::kSuffix.size());
    const QByteArray begun = QFile::encodeName(stem + JournalWriter::kBegunSuffix);
    const int descriptor =
        ::open(begun.constData(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (descriptor < 0) {
        return cannot(m_folder, errno);
    }
    JournalLines lines;
    const std::string text = lines.begin(document);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 || !writeAll(descriptor, text) || !syncData(descriptor) ||
        std::rename(begun.constData(), QFile::encodeName(m_path).constData()) != 0) {
        const int reason = errno;
        ::unlink(begun.constData());
        ::close(descriptor);
        return cannot(m_folder, reason);
    }
    syncFolder(m_folder);
    m_lines = lines;
    m_snapshotBytes = text.size();
    take(descriptor, text.size());
    return Done{};
}

void JournalFile::take(int descriptor, std::size_t bytes) {
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
    }
    m_descriptor = descriptor;
    m_bytes = bytes;
}

Status JournalFile::append(std::string_view text) {
    if (!writeAll(m_descriptor, text)) {
        const int reason = errno;
        // Else readers find a line that is cut, which they leave out.
        static_cast<void>(::ftruncate(m_descriptor, static_cast<off_t>(m_bytes)) == 0);
        return cannot(m_folder, reason);
    }
    m_bytes += text.size();
    return Done{};
}

Status JournalFile::sync() {
    return m_descriptor < 0 || syncData(m_descriptor) ? Status(Done{}) : cannot(m_folder, errno);
}

void JournalFile::remove() {
    if (m_descriptor >= 0) {
        ::unlink(QFile::encodeName(m_path).constData());
        take(-1, 0);
    }
}

bool JournalFile::isLarge() const {
    return m_bytes - m_snapshotBytes > kRoom + kManyTimes * m_snapshotBytes;
}

}  // namespace hitscope
