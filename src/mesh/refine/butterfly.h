// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "mesh/refine/refine_work.h"

namespace hitscope {

/// Where the modified butterfly scheme puts the vertices of edges, by the triangles around them; as
/// OpenMesh's ModifiedButterflyT does it. Where there is no such neighbourhood, at edges of three faces, and
/// at the region's border, whose other side is not refined, it is the middle.
class Butterfly {
public:
    /// `work` outlives this, and stays as it is meanwhile.
    explicit Butterfly(const RefineWork& work);

    /// Of the edge between two places.
    [[nodiscard]] glm::vec3 position(std::uint32_t a, std::uint32_t b) const;

private:
    /// The places around one that is inside, from `first` on; empty: it is on the boundary, or not manifold.
    [[nodiscard]] std::vector<std::uint32_t> ring(std::uint32_t place, std::uint32_t first) const;
    /// The third corner of the triangle that has the side from a to b; kNoIndex: none has it.
    [[nodiscard]] std::uint32_t across(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool isClear(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] glm::dvec3 at(std::uint32_t place) const { return glm::dvec3(m_work.position(place)); }
    [[nodiscard]] glm::dvec3 middle(std::uint32_t a, std::uint32_t b) const { return 0.5 * (at(a) + at(b)); }
    [[nodiscard]] glm::dvec3 onBoundary(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] std::uint32_t alongBoundary(std::uint32_t place, std::uint32_t from, bool isForward) const;
    [[nodiscard]] glm::dvec3 fromEight(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] glm::dvec3 fromRing(std::uint32_t place, const std::vector<std::uint32_t>& ring) const;

    const RefineWork& m_work;
    std::unordered_set<std::uint32_t> m_atBorder;  ///< places of faces that are not in the region
    std::unordered_map<std::uint64_t, std::uint32_t, EdgeHash> m_across;  ///< by side, from place to place
};

}  // namespace hitscope
