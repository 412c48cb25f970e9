// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/target.h"

#include <utility>

namespace hitscope {

Target::Target(TargetId targetId, QString targetName, const RigidTransform& where, const PreparedMesh& shape)
    : id(targetId),
      name(std::move(targetName)),
      transform(where),
      deformed(shape.mesh, shape.render),
      trueNormals(*shape.trueNormals) {}

const TopologyStatistics& Target::topology() const {
    if (!m_topology) {
        m_topology = computeTopology(deformed.original());
    }
    return *m_topology;
}

const GeometryStatistics& Target::originalGeometry() const {
    if (!m_originalGeometry) {
        m_originalGeometry = computeGeometry(deformed.original(), deformed.original().positions, topology());
    }
    return *m_originalGeometry;
}

Bounds Target::worldBounds() const {
    const Bounds& local = deformed.render().bounds;
    Bounds world;
    if (local.empty()) {
        return world;
    }
    for (int corner = 0; corner < 8; ++corner) {
        world.add(transform.toWorld({(corner & 1) != 0 ? local.max.x : local.min.x,
                                     (corner & 2) != 0 ? local.max.y : local.min.y,
                                     (corner & 4) != 0 ? local.max.z : local.min.z}));
    }
    return world;
}

}  // namespace hitscope
