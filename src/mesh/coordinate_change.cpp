// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/coordinate_change.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace hitscope {

namespace {

/// A quarter turn, which takes no rounding. 0 stays 0: -0 is ugly in a file.
template <typename Vec>
Vec turned(const Vec& v, const CoordinateChange& change) {
    using Number = typename Vec::value_type;
    if (change.from == change.to) {
        return v;
    }
    return change.from == UpAxis::Z ? Vec(v.x, v.z, Number(0) - v.y) : Vec(v.x, Number(0) - v.z, v.y);
}

bool isFloat(const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    return std::max({size.x, size.y, size.z}) <= static_cast<double>(std::numeric_limits<float>::max());
}

}  // namespace

Status changeCoordinates(MeshData& mesh, const CoordinateChange& change) {
    if (change.scale == 1.0 && change.from == change.to) {
        return Done{};
    }
    const auto changed = [&change](const glm::dvec3& v) { return turned(change.scale * v, change); };
    const auto isIn = [&changed](const auto& v) { return isFloat(changed(glm::dvec3(v))); };
    if (!std::isfinite(change.scale) || !(change.scale > 0.0) ||
        !std::all_of(mesh.positions.begin(), mesh.positions.end(), isIn) ||
        !std::all_of(mesh.filePositions.begin(), mesh.filePositions.end(), isIn)) {
        return Error{"The mesh cannot have this size.", "", "Choose another scale."};
    }
    for (glm::vec3& position : mesh.positions) {
        position = glm::vec3(changed(glm::dvec3(position)));
    }
    for (glm::dvec3& position : mesh.filePositions) {
        position = changed(position);
    }
    for (glm::vec3& normal : mesh.normals) {
        normal = turned(normal, change);
    }
    mesh.placement.centre = changed(mesh.placement.centre);
    mesh.sourceHash = 0;  // the numbers of its file are others
    return Done{};
}

}  // namespace hitscope
