// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/worker/sandbox.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <cstdint>

#include "core/sanitizers.h"
#include "io/worker/call_filter.h"

namespace hitscope {
namespace {

#ifdef HITSCOPE_SANITIZED
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// All rights over files that a kernel of this version of Landlock knows of: what is not named here, it does
/// not watch over. The headers of Debian 12 know the first two versions only.
std::uint64_t rightsOf(long version) {
    constexpr std::uint64_t kFirst = (1ull << 13) - 1;  // execute, write, read and make
    std::uint64_t rights = kFirst;
    for (const auto& [since, bit] : {std::pair{2, 13}, {3, 14}, {5, 15}}) {  // refer, truncate, devices
        rights |= version >= since ? 1ull << bit : 0;
    }
    return rights;
}

/// Lets `path` be read, and what is below it.
void allowReading(int ruleset, const QString& path, std::uint64_t rights) {
    const int descriptor = ::open(QFile::encodeName(path).constData(), O_PATH | O_CLOEXEC);
    if (descriptor >= 0) {
        landlock_path_beneath_attr rule{};
        rule.allowed_access = rights;
        rule.parent_fd = descriptor;
        ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
        ::close(descriptor);
    }
}

/// Versions from 4 on know more than files; they take the first member alone, too, and the other filter is
/// for the rest.
bool lockFiles(const QString& file) {
    const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) {
        return false;
    }
    const std::uint64_t handled = rightsOf(version);
    const int ruleset = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    if (ruleset < 0) {
        return false;
    }
    allowReading(ruleset, file, LANDLOCK_ACCESS_FS_READ_FILE);
    allowReading(ruleset, QFileInfo(file).absolutePath(),
                 LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR);
    const bool locked = ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
    ::close(ruleset);
    return locked;
}

}  // namespace

void loadWhatComesLate() {
    QImageReader::supportedImageFormats();
}

Lock lockThisProcess(const QString& file) {
    if (kIsSanitized) {
        return {};
    }
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);  // or neither may be asked for
    Lock lock;
    lock.files = lockFiles(file);
    lock.calls = filterCalls();
    return lock;
}

}  // namespace hitscope
