// SPDX-License-Identifier: GPL-3.0-or-later
// Values of targets that a person changes one by one: names, visibility, textures, places, physics.
#include <cmath>
#include <optional>
#include <utility>

#include "session/session.h"
#include "session/session_targets.h"

namespace hitscope {

namespace {

bool isFinite(const RigidTransform& transform) {
    const glm::vec3& p = transform.position;
    const glm::quat& r = transform.rotation;
    return std::isfinite(p.x + p.y + p.z) && std::isfinite(r.x + r.y + r.z + r.w);
}

/// `wanted` as a unit quaternion; one that is unit already keeps its bits, else to be put where it is would
/// turn a target. Nothing: it is no rotation.
std::optional<glm::quat> unitRotation(const glm::quat& wanted) {
    constexpr float kRounding = 1.0e-6f;
    const float length = glm::length(wanted);
    if (!(length > 1.0e-6f)) {
        return std::nullopt;
    }
    return std::abs(length - 1.0f) <= kRounding ? wanted : wanted / length;
}

}  // namespace

Status SessionTargets::rename(TargetId id, const QString& name) {
    const QString trimmed = name.simplified();
    if (trimmed.isEmpty()) {
        return Error{"A target needs a name.", "", "Type at least one letter."};
    }
    if (const Target* renamed = find(id); renamed != nullptr && renamed->name != trimmed) {
        TargetState after = *renamed;
        after.name = trimmed;
        change(*renamed, std::move(after), {SessionUndo::Kind::RenameTarget, 1});
    }
    return Done{};
}

void SessionTargets::setVisible(std::span<const TargetId> ids, bool visible) {
    std::vector<TargetEdit> edits;
    for (const std::size_t index : indicesOf(ids)) {
        const Target& changed = *m_targets[index];
        if (changed.visible != visible) {
            TargetState after = changed;
            after.visible = visible;
            edits.push_back({index, TargetState(changed), std::move(after)});
        }
    }
    const std::size_t count = edits.size();
    change(std::move(edits),
           {visible ? SessionUndo::Kind::ShowTarget : SessionUndo::Kind::HideTarget, count});
}

void SessionTargets::setTexture(std::span<const TargetId> ids, const std::shared_ptr<const MeshData>& mesh,
                                const LocatedTexture& located) {
    std::vector<TargetEdit> edits;
    for (const std::size_t index : indicesOf(ids)) {
        TargetState after = *m_targets[index];
        after.shape.mesh = mesh;
        std::erase_if(after.textures,
                      [&located](const LocatedTexture& known) { return known.name == located.name; });
        after.textures.push_back(located);
        edits.push_back({index, TargetState(*m_targets[index]), std::move(after)});
    }
    change(std::move(edits), {SessionUndo::Kind::TargetTexture, 1});
}

Status SessionTargets::setTransforms(std::span<const TargetPlace> places, SessionUndo::Merge merge) {
    std::vector<TargetEdit> edits;
    bool turned = false;
    for (const auto& [id, transform] : places) {
        const std::optional<glm::quat> rotation = unitRotation(transform.rotation);
        if (!isFinite(transform) || !rotation) {
            return Error{"A target can only be put where its position and rotation are finite numbers.", "",
                         "Keep to the ranges the Scene panel shows."};
        }
        const std::optional<std::size_t> index = indexOf(id);
        if (!index) {
            continue;
        }
        const TargetState before = *m_targets[*index];
        TargetState after = before;
        after.transform = {transform.position, *rotation};
        const bool turns = after.transform.rotation != before.transform.rotation;
        if (turns || after.transform.position != before.transform.position) {
            turned = turned || turns;
            edits.push_back({*index, before, std::move(after)});
        }
    }
    const std::size_t count = edits.size();
    change(std::move(edits),
           {turned ? SessionUndo::Kind::RotateTarget : SessionUndo::Kind::MoveTarget, count}, {}, merge);
    return Done{};
}

Status SessionTargets::setTransform(TargetId id, const RigidTransform& transform, SessionUndo::Merge merge) {
    const TargetPlace place{id, transform};
    return setTransforms({&place, 1}, merge);
}

Status SessionTargets::setPhysics(std::span<const TargetId> ids,
                                  const std::function<void(TargetPhysics&)>& change) {
    std::vector<TargetEdit> edits;
    Status status = Done{};
    for (const std::size_t index : indicesOf(ids)) {
        const TargetState before = *m_targets[index];
        TargetState after = before;
        change(after.physics);
        after.physics = clamped(after.physics);
        if (after.physics == before.physics) {
            continue;
        }
        if (Status set = m_session.m_simulation.setTargetPhysics(before.id, after.physics); !set) {
            status = status ? std::move(set) : std::move(status);
            continue;
        }
        edits.push_back({index, before, std::move(after)});
    }
    if (!edits.empty()) {
        const std::size_t count = edits.size();
        this->change(std::move(edits), {SessionUndo::Kind::TargetPhysics, count}, {},
                     SessionUndo::Merge::WithSameKind);
        Q_EMIT m_session.pictureChanged();
    }
    return status;
}

Status SessionTargets::setPhysics(TargetId id, const TargetPhysics& physics) {
    return setPhysics({&id, 1}, [&physics](TargetPhysics& own) { own = physics; });
}

}  // namespace hitscope
