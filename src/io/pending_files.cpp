// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/pending_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <set>
#include <thread>
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

std::array<int, 2> signalEnds{-1, -1};  // of a pipe: a signal's number goes to a thread that may do anything

extern "C" void passSignalOn(int signal) {
    const int before = errno;
    const auto number = static_cast<std::uint8_t>(signal);
    [[maybe_unused]] const ssize_t written = ::write(signalEnds[1], &number, 1);
    errno = before;
}

void waitForSignal() {
    std::uint8_t number = 0;
    while (::read(signalEnds[0], &number, 1) != 1) {
        if (errno != EINTR) {
            return;
        }
    }
    removePendingFiles();
    std::signal(number, SIG_DFL);
    ::kill(::getpid(), number);
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

void removePendingFilesAt(std::initializer_list<int> signals) {
    if (::pipe2(signalEnds.data(), O_CLOEXEC) != 0) {
        return;
    }
    std::thread(waitForSignal).detach();
    for (const int signal : signals) {
        struct sigaction now {};
        if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) {
            now.sa_handler = passSignalOn;
            now.sa_flags = SA_RESTART;  // and stays: who ends a program may send more than one
            ::sigaction(signal, &now, nullptr);
        }
    }
}

}  // namespace hitscope
