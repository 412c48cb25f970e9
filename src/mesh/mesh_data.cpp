// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hitscope {

Bounds MeshData::bounds() const {
    Bounds bounds;
    for (const glm::vec3& position : positions) {
        bounds.add(position);
    }
    return bounds;
}

void place(MeshData& mesh, float extent) {
    if (mesh.positions.empty()) {
        return;
    }
    if (mesh.filePositions.empty()) {
        mesh.filePositions.assign(mesh.positions.begin(), mesh.positions.end());
    }
    glm::dvec3 lowest(std::numeric_limits<double>::infinity());
    glm::dvec3 highest(-std::numeric_limits<double>::infinity());
    for (const glm::dvec3& position : mesh.filePositions) {
        lowest = glm::min(lowest, position);
        highest = glm::max(highest, position);
    }
    const glm::dvec3 size = highest - lowest;
    const double scale = static_cast<double>(extent) / std::max({size.x, size.y, size.z});
    mesh.placement.centre = 0.5 * lowest + 0.5 * highest;
    // All vertices in one point: there is nothing to scale.
    mesh.placement.scale = std::isfinite(scale) && scale > 0.0 ? scale : 1.0;
    std::transform(mesh.filePositions.begin(), mesh.filePositions.end(), mesh.positions.begin(),
                   [&placement = mesh.placement](const glm::dvec3& position) {
                       return glm::vec3(placement.toLocal(position));
                   });
}

}  // namespace hitscope
