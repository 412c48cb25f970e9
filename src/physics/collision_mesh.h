// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/bounds.h"
#include "core/raw_vector.h"

namespace hitscope {

namespace physics {
class Outermost;
class TriangleTree;
}  // namespace physics

/// A mesh made ready to collide with, at its original shape; shared by all targets of that shape. Making it
/// takes time in proportion to the mesh (about 0.3 s a million triangles), so it may be done on any thread.
/// Then neither adding a target nor its first dent has to wait.
class CollisionMesh {
public:
    using Corners = std::shared_ptr<const RawVector<std::uint32_t>>;

    /// `vertices`: metres, local frame. `corners`: 3 a triangle, two-sided; triangles with an index out of
    /// range or a corner that is not finite are left out, those without area cannot be hit while they have
    /// none.
    CollisionMesh(std::vector<glm::vec3> vertices, Corners corners);
    ~CollisionMesh();
    CollisionMesh(const CollisionMesh&) = delete;
    CollisionMesh& operator=(const CollisionMesh&) = delete;

    [[nodiscard]] const std::vector<glm::vec3>& vertices() const { return m_vertices; }
    [[nodiscard]] const Corners& corners() const { return m_corners; }
    [[nodiscard]] const physics::TriangleTree& tree() const { return *m_tree; }
    /// A triangle with an area is there.
    [[nodiscard]] bool hasSurface() const { return m_hasSurface; }
    [[nodiscard]] Bounds bounds() const;  ///< of the triangles
    /// Null: it has no surface.
    [[nodiscard]] const physics::Outermost* hull() const { return m_hull.get(); }

private:
    std::vector<glm::vec3> m_vertices;
    Corners m_corners;
    std::unique_ptr<const physics::TriangleTree> m_tree;
    std::unique_ptr<const physics::Outermost> m_hull;
    bool m_hasSurface = false;
};

}  // namespace hitscope
