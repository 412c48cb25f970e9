// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/smooth.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>
#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "mesh/refine/face_gate.h"
#include "mesh/refine/moved_shape.h"
#include "mesh/surface/connectivity.h"
#include "mesh/surface/welded_vertices.h"

namespace hitscope {

namespace {

struct SmoothedTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using SmoothedMesh = OpenMesh::PolyMesh_ArrayKernelT<SmoothedTraits>;
using Vertex = OpenMesh::VertexHandle;

/// By place: whether it is in the region.
std::vector<bool> placesIn(const MeshData& mesh, const MeshRegion& region,
                           const std::vector<std::uint32_t>& places) {
    std::vector<bool> inside(mesh.vertexCount(), region.kind == MeshRegion::Kind::Whole);
    if (region.kind == MeshRegion::Kind::Vertices) {
        for (const std::uint32_t vertex : region.vertices) {
            if (vertex < places.size()) {
                inside[places[vertex]] = true;
            }
        }
    } else if (region.kind == MeshRegion::Kind::Balls) {
        const RegionTest test(mesh, region);
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            const glm::vec3& at = mesh.positions[v];
            inside[places[v]] = inside[places[v]] || test.hasPart(std::array{at, at, at});
        }
    }
    return inside;
}

/// The faces around the places that are to be smoothed, as half-edges.
class Smoother {
public:
    Smoother(const MeshData& mesh, const SmoothOptions& options)
        : m_mesh(mesh), m_options(options), m_places(weldedVertices(mesh)), m_handles(mesh.vertexCount()) {
        m_edges.request_vertex_status();
        const std::vector<bool> inside = placesIn(mesh, options.region, m_places);
        omerr().disable();
        FaceGate gate(m_edges);
        std::vector<Vertex> locked;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            add(mesh.face(f), inside, gate, locked);
        }
        for (const Vertex vertex : locked) {
            m_edges.status(vertex).set_locked(true);
        }
    }

    [[nodiscard]] Result<MeshData> smooth(const MeshGoOn& goOn) {
        if (m_edges.n_faces() > 0) {
            OpenMesh::Smoother::JacobiLaplaceSmootherT<SmoothedMesh> smoother(m_edges);
            using Base = OpenMesh::Smoother::SmootherT<SmoothedMesh>;
            smoother.initialize(Base::Tangential_and_Normal, Base::C0);
            for (int pass = 0; pass < m_options.passes; ++pass) {
                const auto borders = m_options.keepBorders ? Borders() : movedBorders();
                smoother.smooth(1);
                for (const auto& [vertex, point] : borders) {
                    m_edges.set_point(vertex, point);
                }
                if (goOn && !goOn(static_cast<double>(pass + 1) / m_options.passes)) {
                    return Error{"Smoothing was cancelled.", "", "The mesh is as it was."};
                }
            }
        }
        return withShape(m_mesh, positions());
    }

private:
    using Borders = std::vector<std::pair<Vertex, OpenMesh::Vec3d>>;

    void add(std::span<const std::uint32_t> face, const std::vector<bool>& inside, FaceGate& gate,
             std::vector<Vertex>& locked) {
        std::vector<std::uint32_t> places;
        for (const std::uint32_t vertex : face) {
            places.push_back(m_places[vertex]);
        }
        if (std::none_of(places.begin(), places.end(), [&](std::uint32_t place) { return inside[place]; })) {
            return;
        }
        std::vector<Vertex> corners;
        for (const std::uint32_t place : places) {
            corners.push_back(handleOf(place, inside[place]));
        }
        if (repeatsVertex(places) || !gate.admits(corners) || !m_edges.add_face(corners).is_valid()) {
            locked.insert(locked.end(), corners.begin(), corners.end());
        }
    }

    Vertex handleOf(std::uint32_t place, bool isInside) {
        Vertex& handle = m_handles[place];
        if (!handle.is_valid()) {
            const glm::dvec3 at(m_mesh.positions[place]);
            handle = m_edges.add_vertex({at.x, at.y, at.z});
            m_edges.status(handle).set_locked(!isInside);
        }
        return handle;
    }

    /// Half the way to the middle of their neighbours along the border.
    [[nodiscard]] Borders movedBorders() const {
        Borders moved;
        for (const Vertex vertex : m_edges.vertices()) {
            if (m_edges.status(vertex).locked() || m_edges.is_isolated(vertex) ||
                !m_edges.is_boundary(vertex)) {
                continue;
            }
            const OpenMesh::HalfedgeHandle next = m_edges.halfedge_handle(vertex);
            const OpenMesh::HalfedgeHandle before = m_edges.prev_halfedge_handle(next);
            const OpenMesh::Vec3d middle = (m_edges.point(m_edges.to_vertex_handle(next)) +
                                            m_edges.point(m_edges.from_vertex_handle(before))) *
                                           0.5;
            moved.emplace_back(vertex, (m_edges.point(vertex) + middle) * 0.5);
        }
        return moved;
    }

    /// A vertex that no pass moved keeps its own bits, and the sign of a zero.
    [[nodiscard]] std::vector<glm::vec3> positions() const {
        std::vector<glm::vec3> positions(m_mesh.positions.begin(), m_mesh.positions.end());
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const Vertex handle = m_handles[m_places[v]];
            if (handle.is_valid() && !m_edges.status(handle).locked()) {
                const OpenMesh::Vec3d& point = m_edges.point(handle);
                const glm::vec3 now(glm::dvec3(point[0], point[1], point[2]));
                positions[v] = now == positions[v] ? positions[v] : now;
            }
        }
        return positions;
    }

    const MeshData& m_mesh;
    const SmoothOptions& m_options;
    std::vector<std::uint32_t> m_places;
    std::vector<Vertex> m_handles;  ///< by place; not valid: it is not near
    SmoothedMesh m_edges;
};

}  // namespace

Result<MeshData> smooth(const MeshData& mesh, const SmoothOptions& options, const MeshGoOn& goOn) {
    if (options.passes < 1 || options.passes > SmoothOptions::kMostPasses) {
        return Error{"Smoothing takes from 1 to 1000 passes.", "", "Choose a number within that."};
    }
    return Smoother(mesh, options).smooth(goOn);
}

}  // namespace hitscope
