// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "core/ids.h"
#include "deform/deformed_mesh.h"
#include "mesh/topology.h"
#include "mesh/true_normals.h"
#include "physics/physics_world.h"
#include "session/prepared_mesh.h"

namespace hitscope {

/// A mesh in the scene that can be hit.
struct Target {
    Target(TargetId targetId, QString targetName, const RigidTransform& where, const PreparedMesh& shape);

    TargetId id;
    QString name;
    RigidTransform transform;
    QString sourcePath;  ///< the file it came from; empty: made by us
    DeformedMesh deformed;
    TrueNormals trueNormals;

    [[nodiscard]] const TopologyStatistics& topology() const;          ///< computed when first asked for
    [[nodiscard]] const GeometryStatistics& originalGeometry() const;  ///< likewise
    [[nodiscard]] Bounds worldBounds() const;                          ///< of the original shape

private:
    mutable std::optional<TopologyStatistics> m_topology;
    mutable std::optional<GeometryStatistics> m_originalGeometry;
};

}  // namespace hitscope
