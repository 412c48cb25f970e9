// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace hitscope {

/// Binds this process: so many seconds of CPU time, bytes of memory that it writes to and bytes a written
/// file; no core files; ends with its parent. `mappedBytes`, the mesh's file, may be mapped besides: a large
/// file that is only looked at is no memory taken. What cannot be set is left as it is.
void limitThisProcess(std::uint64_t seconds, std::uint64_t memoryBytes, std::uint64_t mappedBytes);

}  // namespace hitscope
