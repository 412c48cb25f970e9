// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <span>

#include "session/target_plan.h"

namespace hitscope {

enum class SampleScene : std::uint8_t {
    Turntable,   ///< the teapot on a round stand, which is a target too
    Wall,        ///< 100 targets, spheres and cubes, in a wall of ten by ten
    TwoMillion,  ///< one torus of 2,000,000 triangles
};

[[nodiscard]] std::span<const SampleScene> allSampleScenes();
[[nodiscard]] QString sampleSceneName(SampleScene scene);
/// Takes seconds for the largest; on any thread.
[[nodiscard]] ScenePlan planSampleScene(SampleScene scene);

}  // namespace hitscope
