// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/render_mesh.h"
#include "physics/collision_mesh.h"
#include "physics/outermost.h"
#include "physics/run_array.h"
#include "physics/triangle_math.h"
#include "physics/triangle_tree.h"

namespace hitscope::physics {

/// Where a moving point or sphere first meets a surface.
struct SurfaceCast {
    double fraction = 1.0;  ///< of the motion, [0, 1]
    int triangle = -1;      ///< of a mesh; -1: not a mesh
};

/// One target's triangles as they are now. Local frame, metres.
class MeshSurface {
public:
    /// `original` has a surface.
    explicit MeshSurface(std::shared_ptr<const CollisionMesh> original);

    /// Vertices [first, first + vertices.size()) are now there; out of range: ignored. Costs by the triangles
    /// around those that moved. Returns whether any did.
    bool update(std::uint32_t first, std::span<const DynamicVertex> vertices);
    void reset();                                               ///< to the original
    [[nodiscard]] bool isDented() const { return m_isDented; }  ///< a vertex is not where it was
    [[nodiscard]] Bounds bounds() const { return m_tree.bounds(); }
    [[nodiscard]] const CollisionMesh& original() const { return *m_original; }

    /// Brings `hull`, of this surface as it was when this was last called or in the beginning, up to date.
    void update(Outermost& hull);
    [[nodiscard]] Triangle triangle(std::uint32_t index) const;
    /// First contact of a sphere, `radius` 0: of a point.
    [[nodiscard]] std::optional<SurfaceCast> cast(const glm::dvec3& start, const glm::dvec3& motion,
                                                  double radius) const;
    /// Calls `visit(triangle index, triangle)` for the triangles with an area in boxes within `distance` of
    /// `point`.
    void visitNear(const glm::vec3& point, float distance,
                   const std::function<void(std::uint32_t, const Triangle&)>& visit) const;
    /// Likewise for those in boxes that overlap `box`.
    void visitWithin(const Bounds& box,
                     const std::function<void(std::uint32_t, const Triangle&)>& visit) const;

private:
    Bounds moveRun(std::uint32_t first, std::span<const DynamicVertex> vertices);
    void findDent();
    [[nodiscard]] bool isAway(std::uint32_t vertex) const { return m_at[vertex] != m_at.original(vertex); }
    [[nodiscard]] Triangle triangle(const TriangleTree::Corners& corners) const {
        return {m_at[corners[0]], m_at[corners[1]], m_at[corners[2]]};
    }

    std::shared_ptr<const CollisionMesh> m_original;
    RunPositions m_at;
    TriangleTree m_tree;
    std::vector<TriangleTree::MovedRun> m_runs;  ///< of the update() that runs
    std::vector<std::uint32_t> m_moved;  ///< corners, since the hull was last brought up to date; may repeat
    bool m_movedMany = false;            ///< too many for a list
    bool m_isDented = false;
    std::uint32_t m_dent = 0;  ///< if dented: a vertex that is not where it was
    std::size_t m_whole = 0;   ///< of m_at.changed(), the first ones: none of their vertices is away
};

}  // namespace hitscope::physics
