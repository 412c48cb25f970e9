// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/result.h"
#include "deform/hit.h"
#include "mesh/render_mesh.h"
#include "mesh/surface/surface_samples.h"

namespace hitscope {

/// What a person wants scattered.
struct ScatterPlan {
    bool byDensity = false;
    std::uint32_t count = 100;  ///< hits, [1, kMostScattered]; of no account by density
    double density = 10.0;      ///< hits a square metre, > 0
    std::uint64_t seed = 1;     ///< another seed gives other places, sizes and directions
    double sizeSpread = 0.0;    ///< [0, 1): sizes are 1 - it to 1 + it times the constants'
    bool isInward = true;       ///< into the surface; else along `direction`, where the surface faces it
    glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< local frame, of any length but 0
    double cone = 0.0;  ///< radians, [0, pi/2]: directions leave the middle one by up to this

    bool operator==(const ScatterPlan&) const = default;
};

inline constexpr std::uint32_t kMostScattered = 100'000;

/// Where hits are scattered: a mesh as its vertices are now (`positions`: one a file vertex, metres).
struct ScatterSurface {
    const RenderMesh& mesh;
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> selected;  ///< file vertices, ascending: only triangles that have these at
                                              ///< all corners; empty: all
};

struct ScatteredHits {
    std::vector<Hit> hits;
    double area = 0.0;  ///< square metres that they are scattered over
};

/// Hits spread over a surface as blue noise (sampleSurface()), each like `model` but for point, direction,
/// normal, triangle and the size of its constants. The same plan on the same surface gives the same hits, in
/// every bit. An error where there is no surface, or the plan would give no hit or too many. Empty where goOn
/// said so.
[[nodiscard]] Result<ScatteredHits> scatteredHits(const ScatterSurface& surface, const ScatterPlan& plan,
                                                  const Hit& model, const GoOn& goOn = {});

/// `constants` of a dent `factor` (> 0) times as large, within hitParameters().
[[nodiscard]] DeformationConstants resized(const DeformationConstants& constants, double factor);
/// Makes a hit's dent `factor` (> 0) times as large: its constants, and what presses it.
void resize(Hit& hit, double factor);

}  // namespace hitscope
