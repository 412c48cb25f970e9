// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "deform/hit.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// What hits that have not been made yet would leave of a target: three corners a triangle, metres, local
/// frame.
struct DentGhosts {
    std::vector<glm::vec3> triangles;
    bool areDents =
        true;  ///< the surface as it would be; else a mark for each hit, since it would be too much
};

/// More triangles than this cannot be drawn at once without a pause on a software renderer.
inline constexpr std::size_t kMostGhostTriangles = 60'000;
/// More moves of vertices would keep a person waiting for the ghosts.
inline constexpr std::size_t kMostGhostMoves = 20'000'000;

/// The hits, in order, by the reference deformation, on a mesh whose vertices are now at `positions` (one a
/// file vertex). Where that would be too much: markGhosts() of them. Stops early when isStopped() says so.
[[nodiscard]] DentGhosts dentGhosts(const RenderMesh& mesh, std::span<const glm::vec3> positions,
                                    std::span<const Hit> hits, const std::function<bool()>& isStopped = {});

/// A flat cone for each hit: its rim around the point, as wide as the hit reaches but no wider than `widest`
/// metres, its tip where the direction goes. At most kMostGhostTriangles together.
[[nodiscard]] std::vector<glm::vec3> markGhosts(std::span<const Hit> hits, float widest);

}  // namespace hitscope
