// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bench/bench_room.h"
#include "render/display_options.h"

namespace hitscope::bench {

/// A frame drawn with these options over a plainly shaded one: the paper's row with the most vertices, 0 LP
/// cubes, 6 HP cubes, 0 LP spheres, 10 HP spheres, transform feedback.
[[nodiscard]] Result<double> modeCost(const BenchRoom& room, const Plan& plan, DisplayOptions options);

}  // namespace hitscope::bench
