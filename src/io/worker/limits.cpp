// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/worker/limits.h"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>

#include "core/sanitizers.h"

namespace hitscope {
namespace {

void limit(__rlimit_resource resource, std::uint64_t soft, std::uint64_t hard) {
    rlimit now{};
    if (getrlimit(resource, &now) == 0) {
        const rlimit wanted{std::min<rlim_t>(soft, now.rlim_max), std::min<rlim_t>(hard, now.rlim_max)};
        setrlimit(resource, &wanted);
    }
}

}  // namespace

void limitThisProcess(std::uint64_t seconds, std::uint64_t memoryBytes,
                      [[maybe_unused]] std::uint64_t mappedBytes) {
    constexpr std::uint64_t kGrace = 5;  // seconds between the polite signal and the other one
    [[maybe_unused]] constexpr std::uint64_t kPrograms = 1 << 30;  // addresses of code and libraries, amply
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_CPU, seconds, seconds + kGrace);
    limit(RLIMIT_FSIZE, memoryBytes, memoryBytes);
#ifndef HITSCOPE_SANITIZED  // sanitizers reserve terabytes of addresses
    limit(RLIMIT_DATA, memoryBytes, memoryBytes);
    const std::uint64_t addresses = memoryBytes + mappedBytes + kPrograms;
    limit(RLIMIT_AS, addresses, addresses);
#endif
    std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead, and is reported
}

}  // namespace hitscope
