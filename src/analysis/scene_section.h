// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <span>
#include <vector>

#include "core/ids.h"
#include "mesh/moved_vertex.h"
#include "mesh/section.h"
#include "mesh/section_view.h"
#include "physics/collider.h"
#include "session/session.h"
#include "view/cutting_plane.h"

namespace hitscope {

/// Where a plane cuts one target: as it was and as it is. World, metres.
struct TargetSection {
    TargetId target;
    QString name;
    std::vector<SectionCurve> original;
    std::vector<SectionCurve> deformed;
    SectionDepths depths;  ///< of the deformed curves' corners
};

/// Where a plane cuts a scene.
struct SceneSection {
    CuttingPlane cut;
    std::vector<TargetSection> targets;         ///< visible ones that it cuts
    std::shared_ptr<const SectionLines> lines;  ///< to be drawn, as far exaggerated as the picture
};

/// One target as whoever cuts it knows it: its own copy of the positions, so that it can be cut on another
/// thread. Used by one thread at a time. The first follow() takes time in proportion to the mesh.
class SectionedTarget {
public:
    explicit SectionedTarget(std::shared_ptr<const RenderMesh> mesh) : m_mesh(std::move(mesh)) {}

    /// Takes over where vertices of the file have moved to; before the first call all are where they were.
    void follow(std::span<const MovedVertex> moved);
    /// After follow().
    [[nodiscard]] TargetSection cut(const Plane& world, const RigidTransform& transform) const;
    /// Adds the lines that a picture shows, where displacements are drawn `exaggeration` times as large.
    void addLines(SectionLines& lines, const TargetSection& section, const Plane& world,
                  const RigidTransform& transform, float exaggeration);

private:
    void exaggerate(float factor);

    std::shared_ptr<const RenderMesh> m_mesh;
    std::unique_ptr<MeshSections> m_before;
    std::unique_ptr<MeshSections> m_after;
    std::unique_ptr<MeshSections> m_drawn;  ///< null: nothing is exaggerated
    float m_factor = 0.0f;                  ///< of m_drawn; 0: it is out of date
};

/// The lines of the visible targets as the session has them now, for a picture: in the caller's time, which
/// is in proportion to the meshes. Null where there is no plane.
[[nodiscard]] std::shared_ptr<const SectionLines> sectionLines(const Session& session,
                                                               const CuttingPlane& cut, float exaggeration);

}  // namespace hitscope
