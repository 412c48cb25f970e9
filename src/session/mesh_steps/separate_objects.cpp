// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mesh_steps/separate_objects.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>

#include "deform/dent_shape.h"
#include "deform/reference.h"
#include "mesh/mesh_objects.h"
#include "mesh/same_bits.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope {

namespace {

/// A part while it is hit, to find out which hits move it.
class HitPart {
public:
    explicit HitPart(const RenderMesh& mesh)
        : m_deformation(mesh), m_before(m_deformation.vertices().begin(), m_deformation.vertices().end()) {}

    /// Applies it where it is enabled. Whether a vertex moves, or else is within its reach.
    [[nodiscard]] bool takes(const Hit& hit) {
        if (!hit.enabled) {
            const HitReach reach = reachOf(hit);
            return std::any_of(m_before.begin(), m_before.end(), [&reach](const DynamicVertex& vertex) {
                return glm::distance(vertex.position, reach.centre) <= reach.radius;
            });
        }
        bool moves = false;
        for (const VertexRange& range : m_deformation.apply({&hit, 1})) {
            for (std::uint32_t v = range.first; v < range.first + range.count; ++v) {
                const DynamicVertex& now = m_deformation.vertices()[v];
                moves = moves || !sameBits(now.position, m_before[v].position);
                m_before[v] = now;
            }
        }
        return moves;
    }

private:
    ReferenceDeformation m_deformation;
    std::vector<DynamicVertex> m_before;
};

/// The part whose box is nearest.
std::uint32_t nearestPart(const std::vector<TargetState>& parts, const glm::vec3& point) {
    const auto distance = [&point](const TargetState& part) {
        const Bounds& box = part.shape.render->bounds;
        return glm::distance(point, glm::clamp(point, box.min, box.max));
    };
    const auto nearest = std::min_element(
        parts.begin(), parts.end(),
        [&](const TargetState& a, const TargetState& b) { return distance(a) < distance(b); });
    return static_cast<std::uint32_t>(nearest - parts.begin());
}

/// False: it was cancelled.
bool distribute(SeparatedObjects& objects, const MeshGoOn& goOn) {
    constexpr std::size_t kHitsBetweenLooks = 64;
    objects.partsOfHit.resize(objects.hits.size());
    const auto steps = static_cast<double>(objects.parts.size() * objects.hits.size());
    for (std::uint32_t p = 0; p < objects.parts.size(); ++p) {
        HitPart part(*objects.parts[p].shape.render);
        for (std::size_t i = 0; i < objects.hits.size(); ++i) {
            const auto done = static_cast<double>(p * objects.hits.size() + i);
            if (goOn && i % kHitsBetweenLooks == 0 && !goOn(0.5 + 0.5 * done / steps)) {
                return false;
            }
            if (part.takes(objects.hits[i])) {
                objects.partsOfHit[i].push_back(p);
            }
        }
    }
    for (std::size_t i = 0; i < objects.hits.size(); ++i) {
        if (objects.partsOfHit[i].empty()) {
            objects.partsOfHit[i].push_back(nearestPart(objects.parts, objects.hits[i].point));
        }
    }
    return true;
}

TargetState partOf(const TargetState& target, MeshData mesh, std::uint32_t object, std::size_t count) {
    MeshSteps steps = target.steps;
    steps.push_back(std::make_shared<const MeshStep>(OnlyObject{object}));
    TargetPlan plan = planMesh(prepareMesh(std::move(mesh)), target.source, std::move(steps));
    plan.sourcePath = target.sourcePath;
    plan.textures = target.textures;
    TargetState part = stateOf(std::move(plan), target.id);
    part.transform = target.transform;
    part.visible = target.visible;
    part.physics = target.physics;
    part.physics.mass /= static_cast<float>(count);
    part.physics = clamped(part.physics);
    return part;
}

}  // namespace

Result<SeparatedObjects> separated(const TargetState& target, std::vector<Hit> hits, const MeshGoOn& goOn) {
    const Error cancelled{"It was cancelled.", "", "The mesh is unchanged."};
    const MeshObjects objects(*target.shape.mesh);
    const std::size_t count = objects.count();
    if (count < 2) {
        return Error{"The mesh has one object only.", "", "There is nothing to separate."};
    }
    if (count > kMostParts) {
        return Error{"The mesh has " + std::to_string(count) + " objects; at most " +
                         std::to_string(kMostParts) + " can become targets.",
                     "", "Join some of them in a modelling program."};
    }
    if (target.steps.size() >= kMostMeshSteps) {
        return Error{"The mesh was changed " + std::to_string(kMostMeshSteps) + " times already.", "",
                     "Export it, and go on with the exported mesh."};
    }
    SeparatedObjects made{target, std::move(hits), {}, {}, {}};
    for (std::uint32_t i = 0; i < count; ++i) {
        if (goOn && !goOn(0.5 * static_cast<double>(i) / static_cast<double>(count))) {
            return cancelled;
        }
        MeshData mesh =
            objects.only(i);  // as withStep() makes it, which would look for all objects each time
        if (const Status valid = validate(mesh); !valid) {
            return valid.error();
        }
        made.parts.push_back(partOf(target, std::move(mesh), i, count));
        made.vertices.push_back(objects.vertices(i));
    }
    if (!distribute(made, goOn)) {
        return cancelled;
    }
    return made;
}

Status takeSeparated(Session& session, const SeparatedObjects& objects) {
    const TargetId id = objects.before.id;
    if (session.targets().find(id) == nullptr) {
        return Error{"The target is not there any more.", "", "Nothing was changed."};
    }
    if (meshEdit(session, id, {}).hits != objects.hits) {
        return Error{"The hits were changed while the objects were separated.", "", "Do it again."};
    }
    const std::span<const std::uint32_t> vertices = session.selection().vertices(id);
    const std::vector<std::uint32_t> selected(vertices.begin(), vertices.end());
    const std::vector<TargetId> ids = session.targets().replaceByParts(id, objects.parts, objects.partsOfHit);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        std::vector<std::uint32_t> chosen;
        for (const std::uint32_t vertex : selected) {
            const auto& all = objects.vertices[i];
            const auto found = std::lower_bound(all.begin(), all.end(), vertex);
            if (found != all.end() && *found == vertex) {
                chosen.push_back(static_cast<std::uint32_t>(found - all.begin()));
            }
        }
        if (!chosen.empty()) {
            session.selection().select(ids[i], std::move(chosen), VertexSelection::Combine::Add);
        }
    }
    return Done{};
}

std::vector<TargetId> SessionTargets::replaceByParts(TargetId id, std::vector<TargetState> parts,
                                                     std::span<const std::vector<std::uint32_t>> partsOfHit) {
    const std::optional<std::size_t> index = indexOf(id);
    if (!index) {
        return {};
    }
    Names taken = names();
    std::vector<TargetId> ids;
    std::vector<TargetEdit> edits;
    for (TargetState& part : parts) {
        part.id = TargetId{m_next++};
        part.name = freeName(part.name, taken);
        ids.push_back(part.id);
        edits.push_back({*index + ids.size(), std::nullopt, std::move(part)});
    }
    edits.push_back({*index, TargetState(*m_targets[*index]), std::nullopt});
    const std::span<const Hit> history = m_session.m_hits.history().hits();
    std::vector<Hit> hits;
    std::size_t first = history.size();
    std::size_t end = 0;
    for (std::size_t row = 0; row < history.size(); ++row) {
        if (history[row].target == id) {
            first = std::min(first, row);
            end = row + 1;
        }
    }
    auto partsOfNext = partsOfHit.begin();
    for (std::size_t row = first; row < end; ++row) {
        if (history[row].target != id) {
            hits.push_back(history[row]);
            continue;
        }
        for (const std::uint32_t part : *partsOfNext++) {
            hits.push_back(history[row]);
            hits.back().target = ids[part];
            hits.back().triangle = kNoIndex;  // the number of one of another mesh
        }
    }
    std::vector<HistoryEdit> hitEdits;
    if (first < end) {
        hitEdits.push_back(m_session.m_hits.m_history.splice(first, end - first, hits));
    }
    change(std::move(edits), {SessionUndo::Kind::SeparateObjects, 1}, std::move(hitEdits));
    select(ids.front());
    return ids;
}

}  // namespace hitscope
