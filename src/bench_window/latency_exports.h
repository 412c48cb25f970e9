// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bench_window/driven_window.h"
#include "bench_window/latency_row.h"

namespace hitscope::bench {

/// Has the window write its mesh into a folder for temporary files, as OBJ and as GLB, while the picture
/// refines itself: a row for each format, until the file is there and was read back.
[[nodiscard]] std::vector<Row> exportLatency(DrivenWindow& window);

}  // namespace hitscope::bench
