// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/journal_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cerrno>
#include <utility>

#include "document/journal_writer.h"
#include "document/session_document.h"

namespace hitscope {

namespace {

constexpr qint64 kForgotten = 3600;  // seconds after which nobody is still beginning a journal

Error cannot(const char* what, const QString& path, int reason) {
    return {what + qt_error_string(reason).toStdString() + ".", path.toStdString(),
            "See that you may read and write this file."};
}

/// Locked for this process; -1 with errno where another has it, or it is no plain file.
int openLocked(const QString& path) {
    const int descriptor =
        ::open(QFile::encodeName(path).constData(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) {
        return -1;
    }
    struct stat facts {};
    if (::fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_nlink > 0 &&
        ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
        return descriptor;
    }
    const int reason = S_ISREG(facts.st_mode) ? errno : EINVAL;
    ::close(descriptor);
    errno = reason;
    return -1;
}

}  // namespace

QString journalFolder() {
    QString state = qEnvironmentVariable("XDG_STATE_HOME");
    if (!QDir::isAbsolutePath(state)) {  // others are to be ignored, says the specification
        state = QDir::homePath() + QStringLiteral("/.local/state");
    }
    return QDir::cleanPath(state + QStringLiteral("/hitscope/journals"));
}

std::vector<FoundJournal> findJournals(const QString& folder) {
    std::vector<FoundJournal> found;
    const QDir directory(folder);
    const QString begun = QStringLiteral("*%1").arg(JournalWriter::kBegunSuffix);
    const QDateTime now = QDateTime::currentDateTime();
    for (const QFileInfo& file : directory.entryInfoList({begun}, QDir::Files)) {
        if (file.lastModified().secsTo(now) < kForgotten) {
            continue;
        }
        if (const int descriptor = openLocked(file.filePath()); descriptor >= 0) {
            QFile::remove(file.filePath());
            ::close(descriptor);
        }
    }
    const QString all = QStringLiteral("*%1").arg(JournalWriter::kSuffix);
    for (const QFileInfo& file : directory.entryInfoList({all}, QDir::Files, QDir::Time)) {
        if (const int descriptor = openLocked(file.filePath()); descriptor >= 0) {
            found.push_back({file.filePath(), file.lastModified(), file.size()});
            ::close(descriptor);
        }
    }
    return found;
}

Result<ClaimedJournal> ClaimedJournal::claim(const QString& path) {
    const int descriptor = openLocked(path);
    if (descriptor >= 0) {
        return ClaimedJournal(path, descriptor);
    }
    if (errno == EWOULDBLOCK) {
        return Error{"Another window is recovering this journal.", path.toStdString(), "Look there."};
    }
    return cannot("The journal cannot be opened: ", path, errno);
}

ClaimedJournal::~ClaimedJournal() {
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
    }
}

ClaimedJournal::ClaimedJournal(ClaimedJournal&& other) noexcept
    : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)) {}

ClaimedJournal& ClaimedJournal::operator=(ClaimedJournal&& other) noexcept {
    std::swap(m_path, other.m_path);
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
}

Result<QByteArray> ClaimedJournal::read() const {
    QFile file;
    const int copy = ::fcntl(m_descriptor, F_DUPFD_CLOEXEC, 0);
    if (copy < 0 || !file.open(copy, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle) || !file.seek(0)) {
        return cannot("The journal cannot be read: ", m_path, errno);
    }
    if (static_cast<std::size_t>(file.size()) > SessionDocument::kMostBytes) {
        return cannot("The journal cannot be read: ", m_path, EFBIG);
    }
    const QByteArray bytes = file.readAll();
    return file.error() == QFileDevice::NoError ? Result<QByteArray>(bytes)
                                                : cannot("The journal cannot be read: ", m_path, errno);
}

Status ClaimedJournal::discard() {
    if (::unlink(QFile::encodeName(m_path).constData()) != 0 && errno != ENOENT) {
        return cannot("The journal cannot be removed: ", m_path, errno);
    }
    return Done{};
}

Status ClaimedJournal::setAside() {
    const QString aside = m_path + QStringLiteral(".damaged");
    if (::rename(QFile::encodeName(m_path).constData(), QFile::encodeName(aside).constData()) != 0) {
        return cannot("The journal cannot be renamed: ", m_path, errno);
    }
    m_path = aside;
    return Done{};
}

}  // namespace hitscope
