// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mesh_steps/scale_target.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "deform/scattered_hits.h"
#include "session/session.h"

namespace hitscope {

namespace {

/// Local frame: what is in the middle of the lowest side of its box in the world, of the vertices that faces
/// use.
glm::dvec3 footOf(const TargetState& target) {
    const glm::dquat turn(target.transform.rotation);
    glm::dvec3 lowest(std::numeric_limits<double>::infinity());
    glm::dvec3 highest(-std::numeric_limits<double>::infinity());
    const RenderMesh& mesh = *target.shape.render;
    for (std::uint32_t vertex = 0; vertex < mesh.drawnVertices; ++vertex) {
        const glm::dvec3 at = turn * glm::dvec3(mesh.vertices[vertex].position);
        lowest = glm::min(lowest, at);
        highest = glm::max(highest, at);
    }
    const glm::dvec3 middle = 0.5 * (lowest + highest);
    return glm::inverse(turn) * glm::dvec3(middle.x, lowest.y, middle.z);
}

/// About `fixed`, local frame. Moves the mesh, not its file's coordinates.
void scale(MeshData& mesh, double factor, const glm::dvec3& fixed) {
    if (mesh.filePositions.empty()) {
        mesh.filePositions.assign(mesh.positions.begin(), mesh.positions.end());
    }
    Placement& placement = mesh.placement;
    const double after = factor * placement.scale;
    placement.centre -= fixed * ((1.0 - factor) / after);
    placement.scale = after;
    std::transform(
        mesh.filePositions.begin(), mesh.filePositions.end(), mesh.positions.begin(),
        [&placement](const glm::dvec3& position) { return glm::vec3(placement.toLocal(position)); });
}

}  // namespace

Result<ScaledTarget> scaledTo(const TargetState& target, double extent) {
    if (!target.steps.empty()) {
        return Error{"The mesh was changed at this size, by the Mesh menu.", "", "Undo that first."};
    }
    const glm::vec3 size = target.shape.render->bounds.size();
    const double largest = static_cast<double>(std::max({size.x, size.y, size.z}));
    const double factor = extent / largest;
    const double after = factor * target.shape.mesh->placement.scale;
    if (!(extent > 0.0) || !(largest > 0.0) || !std::isfinite(after) || !(after > 0.0)) {
        return Error{"The mesh cannot have this size.", "", "Choose a size above 0, of a mesh that has one."};
    }
    const glm::dvec3 fixed = footOf(target);
    MeshData mesh = *target.shape.mesh;
    scale(mesh, factor, fixed);
    ScaledTarget scaled;
    scaled.factor = static_cast<float>(factor);
    scaled.fixed = glm::vec3(fixed);
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
    const std::span<const std::uint32_t> vertices = session.selection().vertices(scaled.state.id);
    std::vector<std::uint32_t> selected(vertices.begin(), vertices.end());
    const auto ids =
        session.targets().replaceMeshes({&scaled.state, 1}, carried, SessionUndo::Kind::ScaleTarget);
    session.selection().select(ids.at(scaled.state.id), std::move(selected), VertexSelection::Combine::Add);
    return Done{};
}

}  // namespace hitscope
