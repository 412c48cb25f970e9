// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/refine/refine.h"

namespace hitscope {

/// A corner of a face: indices into positions, texcoords and normals.
struct RefineCorner {
    std::uint32_t vertex = 0;
    std::uint32_t texcoord = kNoIndex;
    std::uint32_t normal = kNoIndex;
};

/// An edge by its two places, the lower first.
[[nodiscard]] inline std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32U | b : std::uint64_t{b} << 32U | a;
}

/// Spreads keys over all bits, and breaks ties in no direction.
[[nodiscard]] inline std::uint64_t mixed(std::uint64_t key) {
    key = (key ^ key >> 31U) * 0x9e3779b97f4a7c15U;
    key = (key ^ key >> 29U) * 0xbf58476d1ce4e5b9U;
    return key ^ key >> 32U;
}
struct EdgeHash {
    std::size_t operator()(std::uint64_t key) const { return static_cast<std::size_t>(mixed(key)); }
};

/// The edges that one pass cuts, and where.
struct CutEdge {
    std::optional<glm::vec3> position;  ///< nothing: its middle
    std::uint32_t place = kNoIndex;     ///< of the new vertex, once there is one
};
using CutEdges = std::unordered_map<std::uint64_t, CutEdge, EdgeHash>;

/// A mesh while it is refined: its vertices, and those faces that are in the region or beside it.
class RefineWork {
public:
    struct Face {
        std::uint32_t first = 0;  ///< its corners: corners()[first] and the following
        std::uint32_t count = 0;
        std::uint32_t source = 0;  ///< face of the mesh that it is a part of
        bool inRegion = false;
    };

    /// All outlive this.
    RefineWork(const MeshData& mesh, const RegionTest& region);

    [[nodiscard]] std::span<const Face> faces() const { return m_faces; }
    [[nodiscard]] std::span<const RefineCorner> cornersOf(const Face& face) const {
        return std::span(m_corners).subspan(face.first, face.count);
    }
    /// For each vertex the first at its place: what is at one place is cut alike.
    [[nodiscard]] std::uint32_t placeOf(std::uint32_t vertex) const { return m_places[vertex]; }
    [[nodiscard]] std::uint32_t placeOf(const RefineCorner& corner) const { return m_places[corner.vertex]; }
    [[nodiscard]] const glm::vec3& position(std::uint32_t vertex) const {
        return m_made.mesh.positions[vertex];
    }
    [[nodiscard]] double squaredLength(std::uint32_t a, std::uint32_t b) const;
    /// Calls for each side of a face with its two corners' vertices.
    template <class Call>
    void forSides(const Face& face, const Call& call) const {
        const std::span<const RefineCorner> corners = cornersOf(face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            call(corners[i].vertex, corners[i + 1 < corners.size() ? i + 1 : 0].vertex);
        }
    }
    /// Faces there would be if this were all.
    [[nodiscard]] std::size_t faceCount() const { return m_untouched + m_faces.size(); }

    /// Every face for which `decide` says so becomes triangles.
    void triangulate(const std::function<bool(const Face&)>& decide);
    /// Cuts these edges in all faces that have them. Quads of which all four are cut become four quads.
    void cut(CutEdges& edges);

    /// What came of it. Call once, last.
    [[nodiscard]] RefinedMesh take();

private:
    friend class FaceCutter;

    struct Parts {
        std::vector<Face> faces;
        std::vector<RefineCorner> corners;
    };
    void copy(const Face& face, Parts& parts) const;
    void add(const Face& parent, std::span<const RefineCorner> corners, Parts& parts) const;
    [[nodiscard]] RefineCorner between(const RefineCorner& a, const RefineCorner& b, CutEdge& edge);
    [[nodiscard]] RefineCorner centreOf(std::span<const RefineCorner> quad);
    [[nodiscard]] std::uint32_t vertexBetween(std::uint32_t a, std::uint32_t b, CutEdge& edge);
    std::uint32_t addVertex(const glm::vec3& position, const std::array<std::uint32_t, 4>& parents,
                            std::uint32_t place);
    [[nodiscard]] std::uint32_t texcoordBetween(std::uint32_t a, std::uint32_t b);
    [[nodiscard]] std::uint32_t normalBetween(std::uint32_t a, std::uint32_t b);
    void fillFaces();
    void fillGroups(const std::vector<std::uint32_t>& starts);

    using Between = std::unordered_map<std::uint64_t, std::uint32_t, EdgeHash>;

    const MeshData& m_mesh;
    const RegionTest& m_region;
    RefinedMesh m_made;
    std::vector<std::uint32_t> m_places;
    std::vector<Face> m_faces;  ///< in the order of their sources
    std::vector<RefineCorner> m_corners;
    std::size_t m_untouched = 0;  ///< faces of the mesh that are not among them
    Between m_vertices;           ///< of the pass, by the two they are between
    Between m_texcoords;
    Between m_normals;
};

}  // namespace hitscope
