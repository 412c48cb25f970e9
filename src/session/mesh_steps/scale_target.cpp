// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mesh_steps/scale_target.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "deform/scattered_hits.h"
#include "session/session.h"

namespace hitscope {

namespace {

/// The middle of its lowest side.
glm::dvec3 footOf(const Bounds& bounds) {
    const glm::dvec3 centre(bounds.centre());
    return {centre.x, static_cast<double>(bounds.min.y), centre.z};
}

/// Moves the mesh, not its file's coordinates.
void standOn(MeshData& mesh, const glm::dvec3& foot) {
    Placement& placement = mesh.placement;
    const glm::dvec3 now = footOf(mesh.bounds());
    placement.centre += (now - foot) / placement.scale;
    std::transform(
        mesh.filePositions.begin(), mesh.filePositions.end(), mesh.positions.begin(),
        [&placement](const glm::dvec3& position) { return glm::vec3(placement.toLocal(position)); });
}

}  // namespace

Result<ScaledTarget> scaledTo(const TargetState& target, double extent) {
    if (!target.steps.empty()) {
        return Error{"The mesh was changed at this size, by the Mesh menu.", "", "Undo that first."};
    }
    MeshData mesh = *target.shape.mesh;
    const Bounds before = mesh.bounds();
    const glm::vec3 size = before.max - before.min;
    const double largest = static_cast<double>(std::max({size.x, size.y, size.z}));
    if (!(extent > 0.0) || !std::isfinite(extent) || mesh.positions.empty() || !(largest > 0.0)) {
        return Error{"The mesh cannot have this size.", "", "Choose a size above 0, of a mesh that has one."};
    }
    const double scaleBefore = mesh.placement.scale;
    place(mesh, static_cast<float>(extent));
    standOn(mesh, footOf(before));
    ScaledTarget scaled;
    scaled.factor = static_cast<float>(mesh.placement.scale / scaleBefore);
    scaled.fixed = glm::vec3(footOf(before));
    TargetPlan plan = planMesh(prepareMesh(std::move(mesh)), target.source);
    plan.sourcePath = target.sourcePath;
    plan.textures = target.textures;
    scaled.state = stateOf(std::move(plan), target.id);
    return scaled;
}

Status takeScaled(Session& session, const ScaledTarget& scaled) {
    if (session.targets().find(scaled.state.id) == nullptr) {
        return Error{"The target is not there any more.", "", "Nothing was changed."};
    }
    const auto carried = [&scaled](const Hit& hit) {
        Hit other = hit;
        other.point = scaled.fixed + scaled.factor * (hit.point - scaled.fixed);
        other.triangle = kNoIndex;  // the number of one of another mesh
        resize(other, static_cast<double>(scaled.factor));
        const Result<Hit> checked = checkedHit(other);
        return checked ? std::optional(checked.value()) : std::nullopt;
    };
    session.targets().replaceMeshes({&scaled.state, 1}, carried, SessionUndo::Kind::ScaleTarget);
    return Done{};
}

}  // namespace hitscope
