// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope::bench {

/// Comes back when all that was asked of the current context is done (glFinish).
void finishGpu();

}  // namespace hitscope::bench
