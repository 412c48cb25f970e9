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
    [[nodiscard]] std::size_t slot(std::size_t corner) const {
        return indices.empty() ? corner : indices[corner];
    }
    [[nodiscard]] const glm::vec3& operator[](std::size_t corner) const { return values[slot(corner)]; }
};

/// Some of a mesh's corners: a bit for each.
class CornerSet {
public:
    static constexpr std::size_t kBits = 64;

    [[nodiscard]] bool empty() const { return m_words.empty(); }
    [[nodiscard]] bool has(std::size_t corner) const {
        return !empty() && (m_words[corner / kBits] >> corner % kBits & 1u) != 0;
    }
    /// Whether any of [first, end) is one of them.
    [[nodiscard]] bool hasBetween(std::size_t first, std::size_t end) const;
    /// For filling: bits of corners [kBits * word, kBits * (word + 1)).
    [[nodiscard]] std::vector<std::uint64_t>& words() { return m_words; }
    [[nodiscard]] bool operator==(const CornerSet&) const = default;

private:
    std::vector<std::uint64_t> m_words;  ///< empty: none at all
};

/// How an OBJ file's normals become those of a deformed mesh with the fewest changes: a normal that all of
/// its corners want otherwise is replaced; where they differ, normals are added behind the file's own and the
/// corners refer to these.
struct NormalPlan {
    std::vector<std::uint32_t> replaced;  ///< indices into MeshData::normals, rising
    std::vector<glm::vec3> values;        ///< one for each of `replaced`
    std::vector<glm::vec3> added;         ///< numbered from MeshData::normals.size() on
    CornerSet corners;                    ///< that refer to another normal
    CornerNormalView normals;             ///< those that were given
    std::vector<std::uint32_t> numbers;   ///< of added normals, where a slot of `normals` has one
    /// Corners may refer to normals that the file lacks; the added ones must not become these.
    bool hasDangling = false;

    /// Which one of `corners` refers to.
    [[nodiscard]] std::uint32_t numberOf(std::size_t corner) const { return numbers[normals.slot(corner)]; }
};

/// The vertices that moved to another place: 1 for each, 0 for the others.
[[nodiscard]] std::vector<std::uint8_t> movedVertices(const MeshData& mesh,
                                                      std::span<const glm::vec3> positions);

/// The plan for a mesh whose vertices moved, as movedVertices() says. Corners that have no normal in the file
/// get one only with `all`. Normals that only differ by having been made unit length count as unchanged.
/// What the normals are in outlives the plan.
[[nodiscard]] NormalPlan planNormals(const MeshData& mesh, std::span<const std::uint8_t> moved,
                                     const CornerNormalView& normals, bool all);

/// The file's normal is kept where the given one only differs by having been made unit length.
[[nodiscard]] bool isSameDirection(const glm::vec3& original, const glm::vec3& now);

}  // namespace hitscope
