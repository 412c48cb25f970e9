// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope {

/// Leaves this process, all its threads, the system calls that reading and computing need; all others fail
/// with ENOSYS from now on, for which libraries take another way or give up. False: the kernel has no
/// filters.
[[nodiscard]] bool filterCalls();

}  // namespace hitscope
