// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/bench/bench_room.h"
#include "cli/bench/history.h"

namespace hitscope::bench {

/// What hits that arrive in one frame cost it before the picture is drawn: the session takes them, they are
/// applied, what they changed is read back, normals follow, and all of it is finished. One Samples for each
/// number of hits, seconds a frame; the scene is whole again before each.
[[nodiscard]] Result<std::vector<Samples>> measureArrivals(const BenchRoom& room, const StillScene& scene,
                                                           PipelineKind pipeline,
                                                           const std::vector<int>& hitsAtOnce,
                                                           std::uint32_t seed, const Plan& plan);

}  // namespace hitscope::bench
