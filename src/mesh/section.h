// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "mesh/moved_vertex.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// The points p with dot(normal, p) = offset.
struct Plane {
    glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< unit
    float offset = 0.0f;                 ///< metres along the normal
};

/// A line in which a plane cuts a mesh: points on the mesh's edges, in order. A closed one does not repeat
/// its first point.
struct SectionCurve {
    std::vector<glm::vec3> points;
    bool closed = false;
};

/// Cuts a mesh by planes. Cuts through an edge are the same point for all its triangles, so that curves are
/// whole where the mesh is, even if its file split it (sewnVertices()); a vertex that lies on the plane
/// counts as above it. After the boxes of runs of triangles are made, a cut costs what it cuts and a look at
/// each box.
class MeshSections {
public:
    explicit MeshSections(const RenderMesh& mesh);

    /// Where the file's vertices are now; as many as the mesh has.
    void setPositions(std::span<const glm::vec3> positions);
    /// Where some of them are now: vertices of the file, at the cost of the runs that they are in.
    void move(std::span<const MovedVertex> moved);
    /// Curves that end at the mesh's boundary or where more than two triangles meet come first, then closed
    /// ones.
    [[nodiscard]] std::vector<SectionCurve> cut(const Plane& plane) const;
    /// Of the triangles looked at in cut(): for tests of its cost.
    [[nodiscard]] std::size_t trianglesNear(const Plane& plane) const;

    [[nodiscard]] std::span<const glm::vec3> positions() const { return m_positions; }
    /// 3 a triangle, indices of the file's vertices.
    [[nodiscard]] std::span<const std::uint32_t> triangles() const { return m_triangles; }
    /// By vertex of the file, which one stands for it; empty: each for itself. See sewnVertices().
    [[nodiscard]] std::span<const std::uint32_t> sewn() const { return *m_sewn; }

private:
    void listRuns();
    [[nodiscard]] Bounds boxOf(std::size_t run) const;

    std::vector<glm::vec3> m_positions;
    std::shared_ptr<const std::vector<std::uint32_t>> m_sewn;  ///< of all copies
    std::vector<std::uint32_t> m_triangles;                    ///< neighbours in space are near each other
    std::vector<Bounds> m_runs;                                ///< of kRun triangles each
    std::vector<std::uint32_t> m_runStarts;  ///< of each vertex in m_runsOf, and their end; empty: not made
    std::vector<std::uint32_t> m_runsOf;     ///< runs that a vertex is in, by vertex
};

}  // namespace hitscope
