// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/worker/call_filter.h"

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <initializer_list>
#include <memory>

namespace hitscope {
namespace {

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

/// A list of what is allowed, not of what is not: kernels get new calls. It holds what the C library and Qt
/// call when they read files, decode pictures, make threads (Qt converts large pictures in several) and end.
/// None of these reaches another process, a network or a file that is not open already.
constexpr const char* kHarmless[] = {
    // memory
    "brk",
    "madvise",
    "mmap",
    "mprotect",
    "mremap",
    "munmap",
    // files that are open
    "close",
    "dup",
    "fadvise64",
    "fstat",
    "fstat64",
    "_llseek",
    "lseek",
    "pread64",
    "preadv",
    "pwrite64",
    "read",
    "readv",
    "write",
    "writev",
    // what there is, as far as names go
    "access",
    "faccessat",
    "faccessat2",
    "fstatat64",
    "getcwd",
    "getdents64",
    "lstat",
    "newfstatat",
    "readlink",
    "readlinkat",
    "stat",
    "statx",
    // threads and what they wait for
    "eventfd2",
    "exit",
    "exit_group",
    "futex",
    "futex_time64",
    "gettid",
    "membarrier",
    "pipe2",
    "poll",
    "ppoll",
    "restart_syscall",
    "rseq",
    "sched_getaffinity",
    "sched_getparam",
    "sched_getscheduler",
    "sched_yield",
    "set_robust_list",
    // signals to oneself
    "rt_sigaction",
    "rt_sigprocmask",
    "rt_sigreturn",
    "sigaltstack",
    // clocks and facts
    "clock_getres",
    "clock_gettime",
    "clock_gettime64",
    "clock_nanosleep",
    "clock_nanosleep_time64",
    "getcpu",
    "getegid",
    "geteuid",
    "getgid",
    "getpid",
    "getppid",
    "getrandom",
    "getrlimit",
    "getrusage",
    "gettimeofday",
    "getuid",
    "nanosleep",
    "sysinfo",
    "time",
    "times",
    "ugetrlimit",
    "uname",
};

/// Names that this kind of machine does not have are left out.
bool allow(const Filter& filter, const char* name, std::initializer_list<scmp_arg_cmp> arguments = {}) {
    const int call = seccomp_syscall_resolve_name(name);
    return call == __NR_SCMP_ERROR ||
           seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, static_cast<unsigned>(arguments.size()),
                                  arguments.begin()) == 0;
}

/// Of an argument: the bits of `mask` are `value`.
scmp_arg_cmp bits(unsigned argument, std::uint64_t mask, std::uint64_t value) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

scmp_arg_cmp is(unsigned argument, std::uint64_t value) {
    return {argument, SCMP_CMP_EQ, value, 0};
}

/// Calls that are harmless with some arguments only. Newer ways to say the same, whose arguments lie in
/// memory where no filter sees them (clone3, openat2), fail; the C library then takes these.
bool allowInPart(const Filter& filter) {
    constexpr std::uint64_t kChanging = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND;
    constexpr std::uint64_t kNewSpaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC |
                                         CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
    constexpr std::uint64_t kThread = CLONE_THREAD | CLONE_VM | CLONE_SIGHAND;
    const auto self = static_cast<std::uint64_t>(::getpid());
    bool done = allow(filter, "open", {bits(1, kChanging, O_RDONLY)}) &&
                allow(filter, "openat", {bits(2, kChanging, O_RDONLY)}) &&
                allow(filter, "clone", {bits(0, kThread | kNewSpaces, kThread)}) &&
                allow(filter, "tgkill", {is(0, self)}) &&  // abort()
                allow(filter, "prctl", {is(0, PR_SET_NAME)}) &&
                allow(filter, "prlimit64", {is(0, 0), is(2, 0)});  // asking only
    for (const int command : {F_GETFD, F_SETFD, F_GETFL, F_DUPFD_CLOEXEC}) {
        const auto value = static_cast<std::uint64_t>(command);
        done = done && allow(filter, "fcntl", {is(1, value)}) && allow(filter, "fcntl64", {is(1, value)});
    }
    return done;
}

}  // namespace

bool filterCalls() {
    const Filter filter(seccomp_init(SCMP_ACT_ERRNO(ENOSYS)), &seccomp_release);
    if (!filter) {
        return false;
    }
    for (const char* const name : kHarmless) {
        if (!allow(filter, name)) {
            return false;
        }
    }
    seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_TSYNC, 1);  // all threads
    return allowInPart(filter) && seccomp_load(filter.get()) == 0;
}

}  // namespace hitscope
