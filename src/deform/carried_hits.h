// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "deform/hit.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// How hits on a mesh come to be on another that takes its place, as when its file has changed.
class CarriedHits {
public:
    /// A mesh with what is drawn of it; neither is null.
    struct Shape {
        std::shared_ptr<const MeshData> mesh;
        std::shared_ptr<const RenderMesh> render;
    };
    /// Costs a pass over both. On any thread.
    CarriedHits(Shape before, Shape after);

    /// Both have as many vertices and the same faces of them: what differs is where the vertices are.
    [[nodiscard]] bool isByVertex() const { return m_isByVertex; }
    /// By vertex, a hit goes along with the triangle that it struck, as that was moved, turned and scaled;
    /// where that is as it was, the hit keeps every bit of its numbers. Else, and where its triangle is not
    /// known, it stays at its place in the local frame. `hit` has passed checkedHit(), and the result would.
    [[nodiscard]] Hit carried(Hit hit) const;

private:
    [[nodiscard]] Hit alongWith(const Hit& hit) const;
    void matchTriangles();

    Shape m_before;
    Shape m_after;
    bool m_isByVertex = false;
    std::vector<std::uint32_t> m_triangles;  ///< by vertex: of `after`, for each of `before`
};

}  // namespace hitscope
