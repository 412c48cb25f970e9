// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace hitscope {

/// What a process has in memory, bytes; all 0 where the system does not say (other than Linux, or a process
/// that is gone).
struct ProcessMemory {
    double share = 0.0;     ///< PSS: pages that several processes have count in part
    double resident = 0.0;  ///< RSS
    double most = 0.0;      ///< the most that was ever resident
};
[[nodiscard]] ProcessMemory memoryOf(std::int64_t process);
/// Those that it started and that run.
[[nodiscard]] std::vector<std::int64_t> childrenOf(std::int64_t process);
/// The PSS of a process and of all below it, bytes.
[[nodiscard]] double memoryOfAll(std::int64_t process);

}  // namespace hitscope
