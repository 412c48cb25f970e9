// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mesh_steps/mesh_edit.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "deform/dent_shape.h"
#include "mesh/same_bits.h"
#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope {

namespace {

/// Of both meshes' common vertices those that are elsewhere, and their neighbours on faces.
std::vector<std::uint32_t> movedAndBeside(const MeshData& before, const MeshData& after) {
    std::vector<bool> moved(after.vertexCount(), false);
    for (std::size_t v = 0; v < moved.size(); ++v) {
        moved[v] = !sameBits(before.positions[v], after.positions[v]);
    }
    std::vector<bool> named = moved;
    for (std::size_t f = 0; f < after.faceCount(); ++f) {
        const std::span<const std::uint32_t> face = after.face(f);
        if (std::any_of(face.begin(), face.end(), [&moved](std::uint32_t v) { return moved[v]; })) {
            std::for_each(face.begin(), face.end(), [&named](std::uint32_t v) { named[v] = true; });
        }
    }
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < named.size(); ++v) {
        if (named[v]) {
            vertices.push_back(v);
        }
    }
    return vertices;
}

/// Enabled; by no target's number, which means nothing once they are applied.
std::vector<Hit> enabledOf(const std::vector<Hit>& hits) {
    std::vector<Hit> enabled;
    for (const Hit& hit : hits) {
        if (hit.enabled) {
            enabled.push_back(hit);
            enabled.back().target = TargetId{1};
            enabled.back().triangle = kNoIndex;
        }
    }
    return enabled;
}

Result<MeshRegion> regionOf(const MeshEdit& edit, const MeshData& before, const MeshData& now) {
    MeshRegion region;
    switch (edit.where) {
        case MeshEdit::Where::Whole:
            return region;
        case MeshEdit::Where::Selection:
            if (edit.selected.empty()) {
                return Error{"No vertex of the target is selected.", "",
                             "Select some, or choose another region."};
            }
            region.kind = MeshRegion::Kind::Vertices;
            region.vertices = edit.selected;
            return region;
        case MeshEdit::Where::Aim:
            region.kind = MeshRegion::Kind::Balls;
            region.balls.push_back(edit.aim);
            return region;
        case MeshEdit::Where::Hits:
            break;
    }
    if (std::none_of(edit.hits.begin(), edit.hits.end(), [](const Hit& hit) { return hit.enabled; })) {
        return Error{"The target has no hits.", "", "Shoot at it first, or choose another region."};
    }
    if (edit.appliesHits) {
        region.kind = MeshRegion::Kind::Vertices;
        region.vertices = movedAndBeside(before, now);
        return region;
    }
    region.kind = MeshRegion::Kind::Balls;
    for (const Hit& hit : edit.hits) {
        if (hit.enabled) {
            const HitReach reach = reachOf(hit);
            region.balls.push_back({reach.centre, reach.radius});
        }
    }
    return region;
}

void setRegion(MeshStep& step, MeshRegion region) {
    std::visit(
        [&region](auto& what) {
            if constexpr (requires { what.region; }) {
                what.region = std::move(region);
            }
        },
        step);
}

/// In all that their dents depend on.
bool isSameHit(const Hit& a, const Hit& b) {
    return sameBits(a.point, b.point) && sameBits(a.direction, b.direction) && sameBits(a.normal, b.normal) &&
           a.constants == b.constants && a.form == b.form && a.enabled == b.enabled;
}

}  // namespace

SessionUndo::Kind MeshEdit::kind() const {
    using Kind = SessionUndo::Kind;
    constexpr Kind kKinds[] = {Kind::RefineMesh, Kind::SimplifyMesh, Kind::SmoothMesh, Kind::ApplyHits,
                               Kind::SeparateObjects};
    return kKinds[step.index()];
}

MeshEdit meshEdit(const Session& session, TargetId target, MeshStep step) {
    MeshEdit edit;
    edit.step = std::move(step);
    const std::span<const std::uint32_t> selected = session.selection().vertices(target);
    edit.selected.assign(selected.begin(), selected.end());
    for (const Hit& hit : session.hits().history().hits()) {
        if (hit.target == target) {
            edit.hits.push_back(hit);
        }
    }
    return edit;
}

Result<EditedMesh> edited(const MeshData& mesh, const MeshEdit& edit, const MeshGoOn& goOn) {
    EditedMesh made;
    const MeshData* now = &mesh;
    const auto take = [&](MeshStep step) -> Status {
        Result<MeshData> result = withStep(*now, step, goOn);
        if (!result) {
            return result.error();
        }
        made.mesh = std::move(result).value();
        made.steps.push_back(std::make_shared<const MeshStep>(std::move(step)));
        now = &made.mesh;
        return Done{};
    };
    const bool appliesOnly = std::holds_alternative<MergedHits>(edit.step);
    if (appliesOnly || edit.appliesHits) {
        if (const Status applied = take(MergedHits{enabledOf(edit.hits)}); !applied || appliesOnly) {
            return applied ? Result<EditedMesh>(std::move(made)) : Result<EditedMesh>(applied.error());
        }
    }
    Result<MeshRegion> region = regionOf(edit, mesh, *now);
    if (!region) {
        return region.error();
    }
    MeshStep step = edit.step;
    setRegion(step, std::move(region).value());
    if (const Status done = take(std::move(step)); !done) {
        return done.error();
    }
    return made;
}

float longestEdge(const MeshData& mesh, const MeshEdit& edit) {
    const Result<MeshRegion> region = regionOf(edit, mesh, mesh);
    if (!region) {
        return 0.0f;
    }
    const std::vector<bool> isIn = RegionTest(mesh, region.value()).faces();
    double longest = 0.0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const std::span<const std::uint32_t> face = mesh.face(f);
        for (std::size_t i = 0; isIn[f] && i < face.size(); ++i) {
            const glm::dvec3 from(mesh.positions[face[i]]);
            const glm::dvec3 to(mesh.positions[face[(i + 1) % face.size()]]);
            longest = std::max(longest, glm::distance(from, to));
        }
    }
    return static_cast<float>(longest);
}

TargetState stateWith(const TargetState& target, EditedMesh mesh) {
    MeshSteps steps = target.steps;
    steps.insert(steps.end(), mesh.steps.begin(), mesh.steps.end());
    TargetPlan plan = planMesh(prepareMesh(std::move(mesh.mesh)), target.source, std::move(steps));
    plan.sourcePath = target.sourcePath;
    plan.textures = target.textures;
    return stateOf(std::move(plan), target.id);
}

Status takeEdited(Session& session, const TargetState& state, const MeshEdit& edit) {
    if (session.targets().find(state.id) == nullptr) {
        return Error{"The target is not there any more.", "", "Nothing was changed."};
    }
    if (state.steps.size() > kMostMeshSteps) {
        return Error{"The mesh was changed " + std::to_string(kMostMeshSteps) + " times already.", "",
                     "Export it, and go on with the exported mesh."};
    }
    const bool applies = edit.appliesHits || std::holds_alternative<MergedHits>(edit.step);
    const std::vector<Hit> now = meshEdit(session, state.id, edit.step).hits;
    const bool isPrefix = now.size() >= edit.hits.size() &&
                          std::equal(edit.hits.begin(), edit.hits.end(), now.begin(), isSameHit);
    if ((applies || edit.where == MeshEdit::Where::Hits) && !isPrefix) {
        return Error{applies ? "The hits were changed while they were applied."
                             : "The hits were changed while the mesh was.",
                     "", "Do it again."};
    }
    std::size_t row = 0;
    const auto carried = [&](const Hit& hit) -> std::optional<Hit> {
        if (applies && row++ < edit.hits.size() && hit.enabled) {
            return std::nullopt;
        }
        Hit other = hit;
        other.triangle = kNoIndex;  // the number of one of another mesh
        return other;
    };
    const std::span<const std::uint32_t> vertices = session.selection().vertices(state.id);
    std::vector<std::uint32_t> selected(vertices.begin(), vertices.end());
    const auto ids = session.targets().replaceMeshes({&state, 1}, carried, edit.kind());
    if (!std::holds_alternative<SimplifyOptions>(edit.step)) {
        session.selection().select(ids.at(state.id), std::move(selected), VertexSelection::Combine::Add);
    }
    return Done{};
}

}  // namespace hitscope
