// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace hitscope {

/// Binds this process: so many seconds of CPU time, bytes of address space and bytes a written file; no core
/// files; ends with its parent. What cannot be set is left as it is.
void limitThisProcess(std::uint64_t seconds, std::uint64_t memoryBytes);

}  // namespace hitscope
