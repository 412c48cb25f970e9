// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// A ball in the mesh's frame: what a hit reaches.
struct RegionBall {
    glm::vec3 centre{0.0f};  ///< metres, local frame
    float radius = 0.0f;     ///< metres, >= 0
    bool operator==(const RegionBall&) const = default;
};

/// The part of a mesh that something is done to, as a set of faces.
struct MeshRegion {
    enum class Kind : std::uint8_t {
        Whole,     ///< all faces
        Vertices,  ///< those with a corner at one of `vertices`
        Balls,     ///< those that come into one of `balls`
    };
    Kind kind = Kind::Whole;
    std::vector<std::uint32_t> vertices;  ///< ascending; numbers that the mesh does not have are passed over
    std::vector<RegionBall> balls;

    bool operator==(const MeshRegion&) const = default;
};

/// Tells which faces are in a region.
class RegionTest {
public:
    /// Both outlive this.
    RegionTest(const MeshData& mesh, const MeshRegion& region);

    /// Of a face of the mesh.
    [[nodiscard]] bool has(std::span<const std::uint32_t> face) const;
    /// Of a part of a face that is in the region; `corners`: 3 or more, metres, local frame.
    [[nodiscard]] bool hasPart(std::span<const glm::vec3> corners) const {
        return m_region.kind != MeshRegion::Kind::Balls || isNearBall(corners);
    }
    /// The faces of the mesh that are in the region: F entries.
    [[nodiscard]] std::vector<bool> faces() const;

private:
    /// A box around balls [first, first + count) of m_balls, or around the nodes at `first` and first + 1.
    struct Node {
        Bounds box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;  ///< 0: it has two nodes
    };
    void build(std::size_t node, std::size_t first, std::size_t count);
    [[nodiscard]] bool isNearBall(std::span<const glm::vec3> corners) const;
    [[nodiscard]] bool isNearBall(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const;

    const MeshData& m_mesh;
    const MeshRegion& m_region;
    std::vector<bool> m_isNamed;  ///< one a vertex, for Kind::Vertices
    std::vector<RegionBall> m_balls;
    std::vector<Node> m_nodes;
};

/// Squared distance of a point from a triangle, which may have no area.
[[nodiscard]] double squaredDistance(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
                                     const glm::dvec3& c);

}  // namespace hitscope
