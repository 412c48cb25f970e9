// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/pending_files.h"

#include <unistd.h>

#include <QDir>
#include <QFile>
#include <mutex>
#include <set>
#include <vector>

namespace hitscope {

namespace {

constexpr int kTries = 100;

struct PendingFiles {
    std::mutex mutex;
    std::set<QByteArray> paths;
    std::vector<QByteArray> newFolders;  // outer ones first
};

PendingFiles& pendingFiles() {
    static auto* const files = new PendingFiles;  // for as long as any thread runs
    return *files;
}

}  // namespace

void notePending(const QByteArray& path) {
    const std::scoped_lock lock(pendingFiles().mutex);
    pendingFiles().paths.insert(path);
}

void forgetPending(const QByteArray& path) {
    const std::scoped_lock lock(pendingFiles().mutex);
    pendingFiles().paths.erase(path);
}

void noteNewFolder(const QByteArray& path) {
    const std::scoped_lock lock(pendingFiles().mutex);
    pendingFiles().newFolders.push_back(path);
}

void forgetNewFolder(const QByteArray& path) {
    const std::scoped_lock lock(pendingFiles().mutex);
    std::erase(pendingFiles().newFolders, path);
}

void removePendingFiles() {
    const std::scoped_lock lock(pendingFiles().mutex);
    for (const QByteArray& path : pendingFiles().paths) {
        if (::unlink(path.constData()) != 0) {
            QDir folder(QFile::decodeName(path));
            for (int tries = 0; tries < kTries && folder.exists() && !folder.removeRecursively(); ++tries) {
                // Another thread has written into it meanwhile.
            }
        }
    }
    std::vector<QByteArray>& folders = pendingFiles().newFolders;
    for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
        ::rmdir(folder->constData());
    }
    pendingFiles().paths.clear();
    folders.clear();
}

}  // namespace hitscope
