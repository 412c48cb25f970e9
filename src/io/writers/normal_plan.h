// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// Normals of face corners without a copy for each: corner c has values[indices[c]], or values[c] where there
/// are no indices.
struct CornerNormalView {
    std::span<const glm::vec3> values;       ///< unit length
    std::span<const std::uint32_t> indices;  ///< empty, or one for each corner

    [[nodiscard]] bool empty() const { return values.empty(); }
    [[nodiscard]] std::size_t size() const { return indices.empty() ? values.size() : indices.size(); }
    [[nodiscard]] const glm::vec3& operator[](std::size_t corner) const {
        return values[indices.empty() ? corner : indices[corner]];
    }
};

/// How an OBJ file's normals become those of a deformed mesh with the fewest changes: a normal that all of
/// its corners want otherwise is replaced; where they differ, normals are added behind the file's own and the
/// corners refer to these.
struct NormalPlan {
    std::vector<std::uint32_t> replaced;       ///< indices into MeshData::normals, rising
    std::vector<glm::vec3> values;             ///< one for each of `replaced`
    std::vector<glm::vec3> added;              ///< numbered from MeshData::normals.size() on
    std::vector<std::uint32_t> corners;        ///< that refer to another normal, rising
    std::vector<std::uint32_t> cornerNormals;  ///< which, one for each of `corners`
};

/// The plan for a mesh whose vertices moved to `positions`. Corners that have no normal in the file get one
/// only with `all`. Normals that only differ by having been made unit length count as unchanged.
[[nodiscard]] NormalPlan planNormals(const MeshData& mesh, std::span<const glm::vec3> positions,
                                     const CornerNormalView& normals, bool all);

/// The file's normal is kept where the given one only differs by having been made unit length.
[[nodiscard]] bool isSameDirection(const glm::vec3& original, const glm::vec3& now);

}  // namespace hitscope
