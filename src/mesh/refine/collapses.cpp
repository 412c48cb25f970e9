// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/collapses.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#include <algorithm>
#include <optional>

#include "mesh/refine/face_gate.h"
#include "mesh/surface/connectivity.h"

namespace hitscope {

namespace {

struct CollapsedTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Vertex = OpenMesh::VertexHandle;

class CollapsedMesh : public OpenMesh::TriMesh_ArrayKernelT<CollapsedTraits> {
public:
    /// What OpenMesh's says, which allocates memory each time and takes half of the whole work. The link
    /// condition: v0 and v1 have no neighbours in common but those across from the edge (Dey, Edelsbrunner,
    /// Guha, Nekhayev: Topology preserving edge contraction, 1999). The decimater asks only of a v0 that is
    /// not locked, and so is on no border.
    [[nodiscard]] bool is_collapse_ok(OpenMesh::HalfedgeHandle v0v1) const {
        const OpenMesh::HalfedgeHandle v1v0 = opposite_halfedge_handle(v0v1);
        const OpenMesh::VertexHandle v0 = to_vertex_handle(v1v0);
        const OpenMesh::VertexHandle v1 = to_vertex_handle(v0v1);
        if (status(edge_handle(v0v1)).deleted() || status(v0).deleted() || status(v1).deleted()) {
            return false;
        }
        const auto across = [this](OpenMesh::HalfedgeHandle edge) {
            return to_vertex_handle(next_halfedge_handle(edge));
        };
        const auto isLone = [this](OpenMesh::HalfedgeHandle edge) {
            const OpenMesh::HalfedgeHandle next = next_halfedge_handle(edge);
            return is_boundary(opposite_halfedge_handle(next)) &&
                   is_boundary(opposite_halfedge_handle(next_halfedge_handle(next)));
        };
        const OpenMesh::VertexHandle left = across(v0v1);
        const OpenMesh::VertexHandle right = across(v1v0);
        if (left == right || isLone(v0v1) || isLone(v1v0)) {
            return false;
        }
        for (const OpenMesh::VertexHandle near : vv_range(v0)) {
            if (near != left && near != right && near != v1 && find_halfedge(near, v1).is_valid()) {
                return false;
            }
        }
        return true;
    }
};

/// What the corners of faces are, by the half-edges' vertices; on the way of a collapse.
struct CornerBook {
    const MeshData* mesh = nullptr;
    std::vector<CollapsedTriangle> triangles;     // by face
    std::vector<std::array<Vertex, 3>> vertices;  // of their corners, likewise

    [[nodiscard]] const CollapsedTriangle& triangle(OpenMesh::FaceHandle face) const {
        return triangles[static_cast<std::size_t>(face.idx())];
    }
    [[nodiscard]] std::size_t slot(OpenMesh::FaceHandle face, Vertex vertex) const {
        const std::array<Vertex, 3>& all = vertices[static_cast<std::size_t>(face.idx())];
        return static_cast<std::size_t>(std::find(all.begin(), all.end(), vertex) - all.begin());
    }
    [[nodiscard]] const RefineCorner& corner(OpenMesh::FaceHandle face, Vertex vertex) const {
        return triangle(face).corners[slot(face, vertex)];
    }
    [[nodiscard]] bool isSameTexcoord(std::uint32_t a, std::uint32_t b) const {
        return a == b || (a != kNoIndex && b != kNoIndex && mesh->texcoords[a] == mesh->texcoords[b]);
    }
    [[nodiscard]] bool isSameNormal(std::uint32_t a, std::uint32_t b) const {
        return a == b || (a != kNoIndex && b != kNoIndex && mesh->normals[a] == mesh->normals[b]);
    }
    [[nodiscard]] bool isSame(const RefineCorner& a, const RefineCorner& b) const {
        return isSameTexcoord(a.texcoord, b.texcoord) && isSameNormal(a.normal, b.normal);
    }

    /// A seam of texture coordinates ends at a vertex: two faces have the same there, but not at the other
    /// end of their edge. Wherever it went, faces would come to lie on both sides of the seam.
    [[nodiscard]] bool endsSeam(const CollapsedMesh& faces, Vertex vertex) const {
        for (const OpenMesh::HalfedgeHandle edge : faces.voh_range(vertex)) {
            const OpenMesh::FaceHandle left = faces.face_handle(edge);
            const OpenMesh::FaceHandle right = faces.opposite_face_handle(edge);
            if (!left.is_valid() || !right.is_valid() || triangle(left).part != triangle(right).part) {
                continue;
            }
            const Vertex other = faces.to_vertex_handle(edge);
            if (isSameTexcoord(corner(left, vertex).texcoord, corner(right, vertex).texcoord) &&
                !isSameTexcoord(corner(left, other).texcoord, corner(right, other).texcoord)) {
                return true;
            }
        }
        return false;
    }

    /// The corner that a face gets at v1 in place of the one at v0: what a face that goes has there, if it
    /// has the same as this one at v0. Nothing: neither has, and the collapse would tear a seam or move a
    /// border; or both have, but not the same at v1, as where a crease ends.
    [[nodiscard]] std::optional<RefineCorner> moved(
        const OpenMesh::Decimater::CollapseInfoT<CollapsedMesh>& at, OpenMesh::FaceHandle face) const {
        const RefineCorner& from = corner(face, at.v0);
        std::optional<RefineCorner> found;
        bool isFoundSmooth = false;
        for (const OpenMesh::FaceHandle going : {at.fl, at.fr}) {
            if (!going.is_valid() || triangle(going).part != triangle(face).part) {
                continue;
            }
            const RefineCorner& same = corner(going, at.v0);
            if (isSameTexcoord(same.texcoord, from.texcoord)) {
                const bool isSmooth = isSameNormal(same.normal, from.normal);
                RefineCorner other = corner(going, at.v1);
                other.normal = isSmooth ? other.normal : kNoIndex;
                if (found && isSmooth == isFoundSmooth && !isSame(*found, other)) {
                    return std::nullopt;
                }
                if (!found || isSmooth) {
                    found = other;
                    isFoundSmooth = isSmooth;
                }
            }
        }
        return found;
    }
};

/// Keeps the corners of faces right while edges are collapsed.
template <class MeshT>
class SeamModule : public OpenMesh::Decimater::ModBaseT<MeshT> {
public:
    DECIMATING_MODULE(SeamModule, MeshT, Seams)

    explicit SeamModule(MeshT& mesh) : Base(mesh, true) {}
    void setBook(CornerBook& book) { m_book = &book; }

    float collapse_priority(const CollapseInfo& at) override {
        if (at.v0 != m_asked) {  // of all edges of a vertex in turn
            m_asked = at.v0;
            m_isEnd = !m_book->mesh->texcoords.empty() && m_book->endsSeam(Base::mesh(), at.v0);
        }
        if (m_isEnd) {
            return static_cast<float>(Base::ILLEGAL_COLLAPSE);
        }
        for (const OpenMesh::FaceHandle face : Base::mesh().vf_range(at.v0)) {
            if (face != at.fl && face != at.fr && !m_book->moved(at, face)) {
                return static_cast<float>(Base::ILLEGAL_COLLAPSE);
            }
        }
        return static_cast<float>(Base::LEGAL_COLLAPSE);
    }

    void preprocess_collapse(const CollapseInfo& at) override {
        m_asked.invalidate();
        for (const OpenMesh::FaceHandle face : Base::mesh().vf_range(at.v0)) {
            if (face == at.fl || face == at.fr) {
                continue;
            }
            const std::optional<RefineCorner> corner = m_book->moved(at, face);
            const std::size_t slot = m_book->slot(face, at.v0);
            const auto index = static_cast<std::size_t>(face.idx());
            if (corner) {
                m_book->triangles[index].corners[slot] = *corner;
            }
            m_book->triangles[index].isChanged = true;
            m_book->vertices[index][slot] = at.v1;
        }
    }

private:
    CornerBook* m_book = nullptr;
    Vertex m_asked;  ///< not valid: none
    bool m_isEnd = false;
};

/// Asks now and then whether to go on.
class Watch : public OpenMesh::Decimater::Observer {
public:
    Watch(const MeshGoOn& goOn, std::size_t collapses)
        : Observer(kEvery), m_goOn(goOn), m_all(std::max<std::size_t>(collapses, 1)) {}

    void notify(size_t step) override {
        const double share = static_cast<double>(step) / static_cast<double>(m_all);
        m_isGivenUp = m_isGivenUp || (m_goOn && !m_goOn(std::min(share, 1.0)));
    }
    [[nodiscard]] bool abort() const override { return m_isGivenUp; }

private:
    static constexpr std::size_t kEvery = 1000;
    const MeshGoOn& m_goOn;
    std::size_t m_all;
    bool m_isGivenUp = false;
};

/// The triangles as half-edges; those that cannot be are kept apart.
class Collapser {
public:
    Collapser(const MeshData& mesh, const std::vector<std::uint32_t>& places,
              const std::vector<CollapsedTriangle>& triangles, const std::vector<bool>& stays)
        : m_source(mesh), m_places(places), m_triangles(triangles), m_handles(mesh.vertexCount()) {
        m_book.mesh = &mesh;
        m_mesh.request_vertex_status();
        m_mesh.request_edge_status();
        m_mesh.request_face_status();
        m_mesh.request_face_normals();
        omerr().disable();
        FaceGate gate(m_mesh);
        std::vector<Vertex> locked;
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            add(t, gate, locked);
        }
        for (const Vertex vertex : m_mesh.vertices()) {
            const bool isFree = !m_mesh.is_isolated(vertex) && !m_mesh.is_boundary(vertex);
            m_mesh.status(vertex).set_locked(!isFree);
        }
        for (const Vertex vertex : locked) {
            m_mesh.status(vertex).set_locked(true);
        }
        for (std::size_t v = 0; v < stays.size(); ++v) {
            if (stays[v] && m_handles[v].is_valid()) {
                m_mesh.status(m_handles[v]).set_locked(true);
            }
        }
        m_mesh.update_face_normals();
    }

    [[nodiscard]] bool collapse(std::size_t wanted, const MeshGoOn& goOn) {
        const std::size_t apart = m_triangles.size() - m_mesh.n_faces();
        const std::size_t left = wanted > apart ? wanted - apart : 0;
        if (left >= m_mesh.n_faces()) {
            return true;
        }
        OpenMesh::Decimater::DecimaterT<CollapsedMesh> decimater(m_mesh);
        OpenMesh::Decimater::ModQuadricT<CollapsedMesh>::Handle quadric;
        OpenMesh::Decimater::ModNormalFlippingT<CollapsedMesh>::Handle flipping;
        SeamModule<CollapsedMesh>::Handle seams;
        decimater.add(quadric);
        decimater.module(quadric).unset_max_err();
        decimater.add(flipping);
        decimater.add(seams);
        decimater.module(seams).setBook(m_book);
        Watch watch(goOn, (m_mesh.n_faces() - left) / 2);
        decimater.set_observer(&watch);
        decimater.initialize();
        decimater.decimate_to_faces(0, left);
        return !watch.abort();
    }

    [[nodiscard]] std::vector<CollapsedTriangle> left() const {
        std::vector<CollapsedTriangle> left;
        for (std::size_t t = 0; t < m_triangles.size(); ++t) {
            const OpenMesh::FaceHandle face = m_faces[t];
            if (!face.is_valid()) {
                left.push_back(m_triangles[t]);
            } else if (!m_mesh.status(face).deleted()) {
                left.push_back(m_book.triangle(face));
            }
        }
        return left;
    }

private:
    void add(std::uint32_t t, FaceGate& gate, std::vector<Vertex>& locked) {
        std::array<std::uint32_t, 3> corners{};
        std::vector<Vertex> vertices;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = m_places[m_triangles[t].corners[i].vertex];
            Vertex& handle = m_handles[corners[i]];
            if (!handle.is_valid()) {
                const glm::dvec3 at(m_source.positions[corners[i]]);
                handle = m_mesh.add_vertex({at.x, at.y, at.z});
            }
            vertices.push_back(handle);
        }
        OpenMesh::FaceHandle face;
        if (!repeatsVertex(corners) && gate.admits(vertices)) {
            face = m_mesh.add_face(vertices);
        }
        m_faces.push_back(face);
        if (face.is_valid()) {
            m_book.triangles.push_back(m_triangles[t]);
            m_book.vertices.push_back({vertices[0], vertices[1], vertices[2]});
        } else {
            locked.insert(locked.end(), vertices.begin(), vertices.end());
        }
    }

    const MeshData& m_source;
    const std::vector<std::uint32_t>& m_places;
    const std::vector<CollapsedTriangle>& m_triangles;
    std::vector<Vertex> m_handles;              ///< by place
    std::vector<OpenMesh::FaceHandle> m_faces;  ///< by triangle; not valid: it is apart
    CollapsedMesh m_mesh;
    CornerBook m_book;
};

}  // namespace

Result<std::vector<CollapsedTriangle>> collapse(const MeshData& mesh,
                                                const std::vector<std::uint32_t>& places,
                                                const std::vector<CollapsedTriangle>& triangles,
                                                const std::vector<bool>& stays, std::size_t wanted,
                                                const MeshGoOn& goOn) {
    Collapser collapser(mesh, places, triangles, stays);
    if (!collapser.collapse(wanted, goOn)) {
        return Error{"Simplifying was cancelled.", "", "The mesh is as it was."};
    }
    return collapser.left();
}

}  // namespace hitscope
