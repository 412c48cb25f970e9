// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "mesh/block_index.h"
#include "mesh/mesh_data.h"
#include "mesh/moved_vertex.h"
#include "mesh/surface/surface_measures.h"
#include "mesh/surface/surface_topology.h"

namespace hitscope {

/// What the hits have done to the health of a face. A face may have several of these.
struct FaceHarm {
    enum class Kind : std::uint8_t { Flipped, Degenerated, Stretched };
    std::uint32_t face = 0;
    Kind kind = Kind::Flipped;
    float stretch = 1.0f;  ///< the most that one of its edges has grown: length now over length before
    bool operator==(const FaceHarm&) const = default;
};

/// How much an edge of the face has grown at most: its length at `positions` over that at `originals`. An
/// edge that had no length counts as infinitely stretched once it has one. All index alike.
[[nodiscard]] float stretchOf(std::span<const std::uint32_t> face, std::span<const glm::vec3> originals,
                              std::span<const glm::vec3> positions);
/// Whether the face looks the other way at `positions` than at `originals`; a face that was degenerate looks
/// nowhere and cannot.
[[nodiscard]] bool isFlipped(std::span<const std::uint32_t> face, std::span<const glm::vec3> originals,
                             std::span<const glm::vec3> positions);

/// Measures a mesh whose vertices move. Sums are kept by blocks of a few hundred faces, edges and vertices;
/// what has moved has its blocks summed anew and the rest is as it was, so that the cost follows the vertices
/// moved, nothing drifts, and the numbers are those of a fresh start to the last bit.
class SurfaceMeasurer {
public:
    /// Starts at the originals: takes time in proportion to the mesh, less what `stop` cuts short (the
    /// object is then of no use).
    SurfaceMeasurer(std::shared_ptr<const MeshData> mesh, std::shared_ptr<const SurfaceTopology> topology,
                    const std::stop_token& stop = {});

    /// A vertex of no change is allowed, and so is one twice: the later counts.
    void move(std::span<const MovedVertex> moved);

    [[nodiscard]] SurfaceMeasures measures() const;
    /// Takes time in proportion to the vertices changed so far.
    [[nodiscard]] Displacements displacements() const;
    /// In the order of faces, at most `most`; sets `found` to how many there are.
    [[nodiscard]] std::vector<FaceHarm> harms(float stretchLimit, std::size_t most, std::size_t& found) const;
    /// Box of the vertices seen through a rigid transform: rotation (row by row orthonormal), then shift.
    [[nodiscard]] Box boxThrough(const glm::dmat3& rotation, const glm::dvec3& shift) const;
    [[nodiscard]] Box originalBoxThrough(const glm::dmat3& rotation, const glm::dvec3& shift) const;

    [[nodiscard]] const MeshData& mesh() const { return *m_mesh; }
    [[nodiscard]] const SurfaceTopology& topology() const { return *m_topology; }
    [[nodiscard]] std::span<const glm::vec3> positions() const {
        return m_index ? m_positions.all() : m_mesh->positions;
    }
    [[nodiscard]] const SurfaceMeasures& original() const { return m_original; }

private:
    struct FaceBlock {
        Spread area;
        Spread aspect;
        double volume = 0.0;
        glm::dvec3 moment{0.0};
        std::uint32_t degenerate = 0;
        std::uint32_t flipped = 0;
        std::uint32_t degenerated = 0;
        float stretch = 1.0f;  ///< the greatest
    };
    void makeIndex();
    [[nodiscard]] FaceBlock measureFaces(std::size_t block) const;
    [[nodiscard]] Spread measureEdges(std::size_t block) const;
    [[nodiscard]] Box measureBox(std::size_t block) const;
    void listHarms(std::size_t block, float stretchLimit, std::size_t most, std::vector<FaceHarm>& harms,
                   std::size_t& found) const;

    std::shared_ptr<const MeshData> m_mesh;
    std::shared_ptr<const SurfaceTopology> m_topology;
    glm::dvec3 m_reference{0.0};  ///< volumes are measured from here: far off they would cancel in rounding
    // All are there once something has moved.
    struct Index {
        BlockIndex faces;
        BlockIndex edges;
    };
    std::optional<Index> m_index;
    PageCopy<glm::vec3> m_positions;
    std::vector<std::uint32_t> m_listed;  ///< file vertices that were ever moved
    std::vector<bool> m_isListed;
    std::vector<FaceBlock> m_faces;
    std::vector<Spread> m_edges;
    std::vector<Box> m_boxes;
    std::vector<std::uint32_t> m_dirtyFaces;  ///< blocks, of the move() that runs
    std::vector<std::uint32_t> m_dirtyEdges;
    std::vector<std::uint32_t> m_dirtyBoxes;
    SurfaceMeasures m_original;
};

}  // namespace hitscope
