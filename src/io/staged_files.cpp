// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/staged_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <thread>

#include "core/give_up.h"
#include "io/descriptor.h"
#include "io/pending_files.h"

namespace hitscope {

namespace {

constexpr std::size_t kPiece = 1 << 20;      // bytes read at once
constexpr std::size_t kDiskPiece = 8 << 20;  // bytes that the disk is given at once

Error cannotSave(const QString& path, int reason) {
    return {"The file cannot be saved: " + qt_error_string(reason).toStdString() + ".", path.toStdString(),
            "Choose a folder that exists, that you may write to and that has room."};
}

/// Of a file's name what leaves room for more in a name on the disk, which has 255 bytes.
QString shortened(QString name) {
    constexpr qsizetype kMostBytes = 200;
    while (QFile::encodeName(name).size() > kMostBytes) {
        name.chop(name.size() > 1 && name.back().isLowSurrogate() ? 2 : 1);
    }
    return name;
}

/// All that can be read, `most` bytes at most; false with errno for more, or where it fails.
bool copyAll(int from, int to, qint64 most) {
    std::vector<char> piece(kPiece);
    for (qint64 copied = 0;;) {
        const ssize_t size = ::read(from, piece.data(), piece.size());
        if (size == 0) {
            return true;
        }
        if (size < 0 && errno == EINTR) {
            continue;
        }
        copied += std::max<ssize_t>(size, 0);
        if (copied > most) {
            errno = EFBIG;
        }
        if (size < 0 || copied > most || !writeAll(to, piece.data(), static_cast<std::size_t>(size))) {
            return false;
        }
    }
}

/// Lets the disk begin while the rest is written.
bool writeInPieces(int descriptor, std::string_view content) {
    for (std::size_t at = 0; at < content.size(); at += kDiskPiece) {
        mayGiveUp();
        const std::string_view piece = content.substr(at, kDiskPiece);
        if (!writeAll(descriptor, piece.data(), piece.size())) {
            return false;
        }
        startToWrite(descriptor, at, piece.size());
    }
    return true;
}

/// What the sync would wait for, a piece at a time: of a long wait somebody may want the end.
bool waitForDisk(int descriptor) {
    struct stat info {};
    if (::fstat(descriptor, &info) != 0) {
        return false;
    }
    for (off_t at = 0; at < info.st_size; at += static_cast<off_t>(kDiskPiece)) {
        mayGiveUp();
        waitUntilWritten(descriptor, static_cast<std::uint64_t>(at), kDiskPiece);
    }
    mayGiveUp();
    return true;
}

bool syncFile(int descriptor) {
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;  // some file systems have no sync
}

void syncFolderOf(const QString& path) {
    const Descriptor folder(::open(QFile::encodeName(QFileInfo(path).absolutePath()).constData(),
                                   O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.isOpen()) {
        syncFile(folder.get());
    }
}

/// Renames, but never over something that exists.
bool renameToNew(const char* from, const char* to) {
    if (::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0) {
        return true;
    }
    if (errno != EINVAL && errno != ENOSYS) {
        return false;
    }
    // A file system without that.
    struct stat info {};
    if (::lstat(to, &info) == 0) {
        errno = EEXIST;
        return false;
    }
    return ::rename(from, to) == 0;
}

/// Keeps a large file that is about to be replaced, and lets go of it on a thread of its own: the system
/// takes 50 ms to free the memory of 200 MB, and would do so within the renaming otherwise.
class ReplacedFile {
public:
    explicit ReplacedFile(const char* path) : m_file(::open(path, O_PATH | O_NOFOLLOW | O_CLOEXEC)) {
        struct stat info {};
        m_isLarge = m_file >= 0 && ::fstat(m_file, &info) == 0 && info.st_size >= kLarge;
    }
    ReplacedFile(const ReplacedFile&) = delete;
    ReplacedFile& operator=(const ReplacedFile&) = delete;
    ~ReplacedFile() {
        if (m_file < 0) {
            return;
        }
        try {
            if (m_isLarge) {
                std::thread([file = m_file] { ::close(file); }).detach();
                return;
            }
        } catch (const std::system_error&) {
            // There is no thread to be had.
        }
        ::close(m_file);
    }

private:
    static constexpr off_t kLarge = 16 << 20;  // bytes
    int m_file;
    bool m_isLarge = false;
};

/// Where a file that is replaced really is; a link may lead to where there is none yet.
QString withoutLinks(const QString& path) {
    constexpr int kMostLinks = 40;  // as the kernel follows
    QFileInfo file(path);
    for (int i = 0; i < kMostLinks && file.isSymLink() && !file.exists(); ++i) {
        file.setFile(file.symLinkTarget());
    }
    const QString real = file.canonicalFilePath();
    return real.isEmpty() ? file.absoluteFilePath() : real;
}

}  // namespace

StagedFiles::StagedFiles(std::function<void()> beforeStep) : m_beforeStep(std::move(beforeStep)) {}

StagedFiles::~StagedFiles() {
    if (!m_isDone) {
        removeNew(0);
    }
    for (const QString& folder : m_newFolders) {
        forgetNewFolder(QFile::encodeName(folder));
    }
}

void StagedFiles::step() const {
    if (m_beforeStep) {
        m_beforeStep();
    }
}

bool StagedFiles::holds(const QString& path) const {
    return std::any_of(m_files.begin(), m_files.end(),
                       [&path](const File& file) { return file.path == path; });
}

QStringList StagedFiles::noteOfOthers(const QString& path) const {
    constexpr qsizetype kMostNamed = 6;
    const QDir folder(QFileInfo(path).absolutePath());
    const QString itself = QFileInfo(path).canonicalFilePath();
    QStringList names;
    for (const File& file : m_files) {
        if (QFileInfo(file.path).canonicalFilePath() != itself) {
            names += folder.relativeFilePath(file.path);
        }
    }
    if (names.isEmpty()) {
        return {};
    }
    const qsizetype more = names.size() - kMostNamed;
    const QString named = names.first(std::min(names.size(), kMostNamed)).join(QStringLiteral(", "));
    return {more > 0 ? QCoreApplication::translate("StagedFiles", "Also written beside it: %1, and %2 more.")
                           .arg(named)
                           .arg(more)
                     : QCoreApplication::translate("StagedFiles", "Also written beside it: %1.").arg(named)};
}

bool StagedFiles::makeFolder(const QString& path) {
    QStringList missing;
    QDir folder(path);
    while (!folder.exists() && !folder.isRoot()) {
        missing.prepend(folder.absolutePath());
        folder.setPath(QFileInfo(folder.absolutePath()).absolutePath());
    }
    for (const QString& name : missing) {
        step();
        if (::mkdir(QFile::encodeName(name).constData(), 0777) != 0 && errno != EEXIST) {
            return false;
        }
        m_newFolders.push_back(name);
        noteNewFolder(QFile::encodeName(name));
    }
    return true;
}

Status StagedFiles::fill(const QString& path, Existing existing, unsigned mode,
                         const std::function<bool(int descriptor)>& write) {
    struct stat before {};
    const bool isThere = ::stat(QFile::encodeName(path).constData(), &before) == 0;
    if (isThere && !S_ISREG(before.st_mode) && !S_ISDIR(before.st_mode)) {  // it would be replaced by a file
        return Error{"This is a device or a pipe, not a file.", path.toStdString(),
                     "Name a file; on the command line, - is the standard output."};
    }
    const QString place = existing == Existing::Replace ? withoutLinks(path) : path;
    const QFileInfo info(place);
    if (info.isDir()) {
        return cannotSave(path, EISDIR);
    }
    if (existing == Existing::Replace && info.isSymLink()) {
        return cannotSave(path, ELOOP);
    }
    // Renaming would replace a file that is write-protected.
    if (existing == Existing::Replace && isThere &&
        ::faccessat(AT_FDCWD, QFile::encodeName(place).constData(), W_OK, AT_EACCESS) != 0) {
        return cannotSave(path, errno);
    }
    const QString hidden = QStringLiteral("%1/.%2.%3")
                               .arg(info.absolutePath(), shortened(info.fileName()),
                                    QString::number(QRandomGenerator::system()->generate64(), 36));
    step();
    const QByteArray temporary = QFile::encodeName(hidden);
    const Descriptor file(
        ::open(temporary.constData(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
    if (!file.isOpen()) {
        return cannotSave(path, errno);
    }
    m_files.push_back({place, temporary, existing});
    notePending(temporary);
    if (existing == Existing::Replace && isThere) {
        static_cast<void>(::fchmod(file.get(), before.st_mode & 0777));
    }
    step();
    if (!write(file.get()) || !waitForDisk(file.get()) || !syncFile(file.get())) {
        return cannotSave(path, errno);
    }
    return Done{};
}

Status StagedFiles::add(const QString& path, std::string_view content, Existing existing, unsigned mode) {
    if (existing == Existing::Keep && !makeFolder(QFileInfo(path).absolutePath())) {
        return cannotSave(path, errno);
    }
    return fill(path, existing, mode,
                [content](int descriptor) { return writeInPieces(descriptor, content); });
}

Status StagedFiles::addCopy(const QString& source, const QString& path, qint64 most) {
    // Not blocking: a pipe that took the file's place must not hold us for ever.
    const Descriptor from(
        ::open(QFile::encodeName(source).constData(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat info {};
    if (!from.isOpen() || ::fstat(from.get(), &info) != 0 || !S_ISREG(info.st_mode) || info.st_size > most) {
        return Error{"The file cannot be copied: it is no longer there, or it is too large.",
                     source.toStdString(), "Open the mesh again."};
    }
    if (!makeFolder(QFileInfo(path).absolutePath())) {
        return cannotSave(path, errno);
    }
    return fill(path, Existing::Keep, info.st_mode & 0777,
                [&from, most](int descriptor) { return copyAll(from.get(), descriptor, most); });
}

Status StagedFiles::commit() {
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        const File& file = m_files[i];
        const QByteArray path = QFile::encodeName(file.path);
        if (i > 0) {
            syncFolderOf(m_files[i - 1].path);  // what it refers to is there for good
        }
        step();
        const ReplacedFile replaced(path.constData());
        const bool isNamed = file.existing == Existing::Keep
                                 ? renameToNew(file.temporary.constData(), path.constData())
                                 : ::rename(file.temporary.constData(), path.constData()) == 0;
        const int reason = errno;
        forgetPending(file.temporary);
        if (!isNamed) {
            removeNew(i);
            m_isDone = true;
            return cannotSave(file.path, reason);
        }
    }
    m_isDone = true;
    step();
    if (!m_files.empty()) {
        syncFolderOf(m_files.back().path);
    }
    return Done{};
}

/// `named`: so many have their names already.
void StagedFiles::removeNew(std::size_t named) {
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        if (i >= named) {
            ::unlink(m_files[i].temporary.constData());
            forgetPending(m_files[i].temporary);
        } else if (m_files[i].existing == Existing::Keep) {
            ::unlink(QFile::encodeName(m_files[i].path).constData());
        }
    }
    for (auto folder = m_newFolders.rbegin(); folder != m_newFolders.rend(); ++folder) {
        ::rmdir(QFile::encodeName(*folder).constData());  // refused unless it is empty
    }
}

Status StagedFiles::add(const QString& path, const std::function<bool(int descriptor)>& write,
                        Existing existing) {
    return fill(path, existing, 0666, write);
}

Status writeWhole(const QString& path, std::string_view content) {
    return writeWhole(path, [content](const PutPiece& put) {
        for (std::size_t at = 0; at < content.size(); at += kDiskPiece) {
            mayGiveUp();
            if (!put(content.substr(at, kDiskPiece))) {
                return;
            }
        }
    });
}

Status writeWhole(const QString& path, const std::function<void(const PutPiece&)>& make) {
    const auto write = [&make](int descriptor) {
        bool isGood = true;
        make([descriptor, &isGood](std::string_view piece) {
            isGood = isGood && writeAll(descriptor, piece.data(), piece.size());
            return isGood;
        });
        return isGood;
    };
    struct stat info {};
    const QByteArray name = QFile::encodeName(path);
    if (::stat(name.constData(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode)) {
        const Descriptor device(::open(name.constData(), O_WRONLY | O_CLOEXEC));
        return device.isOpen() && write(device.get()) ? Status(Done{}) : Status(cannotSave(path, errno));
    }
    StagedFiles files;
    if (const Status added = files.add(path, write); !added) {
        return added;
    }
    return files.commit();
}

bool haveSameContent(const QString& a, const QString& b) {
    QFile one(a);
    QFile other(b);
    if (!one.open(QIODevice::ReadOnly) || !other.open(QIODevice::ReadOnly) || one.size() != other.size()) {
        return false;
    }
    while (!one.atEnd()) {
        const QByteArray piece = one.read(kPiece);
        if (piece.isEmpty() || piece != other.read(kPiece)) {
            return false;
        }
    }
    return true;
}

}  // namespace hitscope
