// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/worker_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QFileInfo>
#include <QProcess>
#include <QProcessEnvironment>
#include <algorithm>

namespace hitscope {
namespace {

/// Where its libraries are, in a place of their own, and what tells sanitizers how to speak. The same locale
/// for all: numbers in files have points.
QProcessEnvironment environmentOfWorker() {
    const QProcessEnvironment ours = QProcessEnvironment::systemEnvironment();
    QProcessEnvironment kept;
    kept.insert(QStringLiteral("LANG"), QStringLiteral("C.UTF-8"));
    for (const char* const each : {"LD_LIBRARY_PATH", "QT_PLUGIN_PATH", "ASAN_OPTIONS", "LSAN_OPTIONS",
                                   "TSAN_OPTIONS", "UBSAN_OPTIONS"}) {
        const QString name = QString::fromLatin1(each);
        if (ours.contains(name)) {
            kept.insert(name, ours.value(name));
        }
    }
    return kept;
}

/// Closed when the program starts, not now: Qt tells by one of them that it does not start.
void closeDescriptorsOnStart() {
    constexpr unsigned kFirst = STDERR_FILENO + 1;
    constexpr unsigned kOnExec = 1u << 2;  // CLOSE_RANGE_CLOEXEC, since Linux 5.11
    if (::syscall(SYS_close_range, kFirst, ~0u, kOnExec) != 0) {
        constexpr int kUsualMost = 1024;
        for (int descriptor = kFirst; descriptor < kUsualMost; ++descriptor) {
            ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
        }
    }
}

}  // namespace

void startWorker(QProcess& process, const QString& worker, const QString& path, const ImportLimits& limits,
                 int answer) {
    process.setStandardInputFile(QProcess::nullDevice());
    process.setStandardErrorFile(QProcess::nullDevice());
    process.setProcessEnvironment(environmentOfWorker());
    process.setWorkingDirectory(QStringLiteral("/"));
    // Between fork and exec of a program with threads: system calls alone.
    process.setChildProcessModifier([answer, bytes = limits.memoryBytes] {
        ::setsid();
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::dup2(answer, STDIN_FILENO);
        closeDescriptorsOnStart();
        rlimit room{};
        if (::getrlimit(RLIMIT_FSIZE, &room) == 0) {
            room.rlim_max = std::min<rlim_t>(room.rlim_max, bytes);
            room.rlim_cur = room.rlim_max;
            ::setrlimit(RLIMIT_FSIZE, &room);
        }
    });
    process.start(QFileInfo(worker).absoluteFilePath(),
                  {path, QString::number(limits.seconds), QString::number(limits.memoryBytes)});
}

void endWorker(qint64 pid) {
    if (pid > 0) {
        ::kill(static_cast<pid_t>(-pid), SIGKILL);
        ::kill(static_cast<pid_t>(pid), SIGKILL);  // it may not lead its group yet
    }
}

std::uint64_t usualImportMemory() {
    constexpr std::uint64_t kMost = 2ull << 30;
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    const long pageSize = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || pageSize <= 0) {
        return kMost;
    }
    return std::min(kMost, static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageSize) / 4);
}

}  // namespace hitscope
