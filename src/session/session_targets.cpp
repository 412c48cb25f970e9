// SPDX-License-Identifier: GPL-3.0-or-later
// The session's targets, one by one: every change of them passes through here.
#include <algorithm>
#include <cmath>
#include <utility>

#include "session/session.h"

namespace hitscope {

namespace {

bool isFinite(const RigidTransform& transform) {
    const glm::vec3& p = transform.position;
    const glm::quat& r = transform.rotation;
    return std::isfinite(p.x + p.y + p.z) && std::isfinite(r.x + r.y + r.z + r.w);
}

/// "High-poly sphere 3" without its number.
QString stem(const QString& name) {
    const qsizetype space = name.lastIndexOf(u' ');
    bool isNumber = false;
    name.mid(space + 1).toUInt(&isNumber);
    return space > 0 && isNumber ? name.left(space) : name;
}

/// `wanted`, with a number where it is one of `taken`; adds it to them.
QString freeName(const QString& wanted, std::set<QString>& taken) {
    QString name = wanted;
    for (int number = 2; !taken.insert(name).second; ++number) {
        name = QStringLiteral("%1 %2").arg(stem(wanted)).arg(number);
    }
    return name;
}

std::vector<Bounds> boundsOf(std::span<const std::unique_ptr<Target>> targets) {
    std::vector<Bounds> bounds;
    bounds.reserve(targets.size());
    for (const std::unique_ptr<Target>& target : targets) {
        bounds.push_back(target->worldBounds());
    }
    return bounds;
}

}  // namespace

// Finding

std::optional<std::size_t> Session::indexOf(TargetId id) const {
    const auto found = std::find_if(m_targets.begin(), m_targets.end(),
                                    [id](const std::unique_ptr<Target>& target) { return target->id == id; });
    return found == m_targets.end() ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(found - m_targets.begin()));
}

/// Ascending, each once.
std::vector<std::size_t> Session::indicesOf(std::span<const TargetId> ids) const {
    std::vector<std::size_t> indices;
    for (const TargetId id : ids) {
        if (const std::optional<std::size_t> index = indexOf(id)) {
            indices.push_back(*index);
        }
    }
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

std::vector<std::size_t> Session::hitsOn(std::span<const TargetId> ids) const {
    std::vector<std::size_t> found;
    const std::span<const Hit> hits = m_history.hits();
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (std::find(ids.begin(), ids.end(), hits[i].target) != ids.end()) {
            found.push_back(i);
        }
    }
    return found;
}

std::set<QString> Session::targetNames() const {
    std::set<QString> names;
    for (const std::unique_ptr<Target>& target : m_targets) {
        names.insert(target->name);
    }
    return names;
}

// Making

TargetState Session::newTarget(TargetPlan plan) {
    TargetState state;
    state.id = TargetId{m_nextTarget++};
    state.name = std::move(plan.name);
    state.transform = plan.transform;
    state.sourcePath = std::move(plan.sourcePath);
    state.shape = std::move(plan.shape);
    // A primitive is struck as what it is until its first dent, then as its triangles.
    std::visit([&state](auto& collider) { collider.surface = state.shape.collision; }, plan.collider);
    state.collider = std::make_shared<const Collider>(std::move(plan.collider));
    return state;
}

Target& Session::insertTarget(std::size_t index, const TargetState& state) {
    const auto at = m_targets.begin() + static_cast<std::ptrdiff_t>(index);
    Target& target = **m_targets.insert(at, std::make_unique<Target>(state));
    m_colliders.add(target.id, target.shape.render);
    letCollide(target);
    return target;
}

void Session::eraseTarget(std::size_t index) {
    const TargetId id = m_targets[index]->id;
    m_physics.removeTarget(id);
    m_colliders.forget(id);
    m_readBack->forget(id);
    m_notHittable.erase(id);
    m_targets.erase(m_targets.begin() + static_cast<std::ptrdiff_t>(index));
    if (m_selectedTarget == id) {
        selectTarget({});
    }
}

// Following a change. A hit is never on a target that is not there: targets come before their hits, and go
// after them. The history has the change already.

void Session::follow(const SessionUndo::Change& change) {
    for (const TargetEdit& edit : change.targets) {
        if (edit.after) {
            follow(edit);
        }
    }
    announceEdits(change.edits);
    for (const TargetEdit& edit : change.targets) {
        if (!edit.after) {
            follow(edit);
        }
    }
    if (!change.targets.empty()) {
        Q_EMIT pictureChanged();
    }
}

void Session::follow(const TargetEdit& edit) {
    if (!edit.before) {
        const TargetId id = insertTarget(edit.index, *edit.after).id;
        Q_EMIT targetAdded(id);
        selectTarget(id);
        return;
    }
    const TargetId id = edit.before->id;
    if (!edit.after) {
        eraseTarget(edit.index);
        Q_EMIT targetRemoved(id);
        return;
    }
    Target& target = *m_targets[edit.index];
    const RigidTransform where = target.transform;
    static_cast<TargetState&>(target) = *edit.after;
    target.deformed.setMaterialsFrom(target.shape.mesh);
    const bool moves = edit.before->transform.position != target.transform.position ||
                       edit.before->transform.rotation != target.transform.rotation;
    if (moves || edit.before->visible != target.visible || edit.before->physics != target.physics) {
        letCollide(target);
    } else {
        // Knocked about since the change was noted down.
        target.transform = where;
    }
    Q_EMIT targetChanged(id);
}

void Session::changeTargets(std::vector<TargetEdit> targets, SessionUndo::Name name,
                            std::vector<HistoryEdit> edits, SessionUndo::Merge merge) {
    if (targets.empty() && edits.empty()) {
        return;
    }
    const SessionUndo::Change change{std::move(edits),  m_constants, m_constants, merge, name,
                                     std::move(targets)};
    recordUndo(change);
    follow(change);
}

void Session::changeTarget(const Target& target, TargetState after, SessionUndo::Name name,
                           SessionUndo::Merge merge) {
    changeTargets({{*indexOf(target.id), TargetState(target), std::move(after)}}, name, {}, merge);
}

// What a person does

void Session::addTargets(std::vector<TargetPlan> plans) {
    makeRoom(plans, boundsOf(m_targets), m_floorHeight);
    std::set<QString> names = targetNames();
    std::vector<TargetEdit> edits;
    for (TargetPlan& plan : plans) {
        plan.name = freeName(plan.name, names);
        edits.push_back({m_targets.size() + edits.size(), std::nullopt, newTarget(std::move(plan))});
    }
    const std::size_t count = edits.size();
    changeTargets(std::move(edits), {SessionUndo::Kind::AddTarget, count});
}

void Session::duplicateTargets(std::span<const TargetId> ids) {
    std::vector<Bounds> taken = boundsOf(m_targets);
    std::set<QString> names = targetNames();
    std::vector<TargetEdit> edits;
    std::vector<Hit> hits;
    for (const std::size_t index : indicesOf(ids)) {
        const Target& original = *m_targets[index];
        std::vector<TargetPlan> place(1);
        place.front().shape = original.shape;
        place.front().transform = original.transform;
        makeRoom(place, taken);
        TargetState copy = original;
        copy.id = TargetId{m_nextTarget++};
        copy.name = freeName(original.name, names);
        copy.transform = place.front().transform;
        taken.push_back(worldBounds(*copy.shape.render, copy.transform));
        for (const Hit& hit : m_history.hits()) {
            if (hit.target == original.id) {
                hits.push_back(hit);
                hits.back().target = copy.id;
            }
        }
        edits.push_back({m_targets.size() + edits.size(), std::nullopt, std::move(copy)});
    }
    if (edits.empty()) {
        return;
    }
    const std::size_t count = edits.size();
    std::vector<HistoryEdit> copied;
    if (!hits.empty()) {
        copied.push_back(m_history.append(hits));
    }
    changeTargets(std::move(edits), {SessionUndo::Kind::DuplicateTarget, count}, std::move(copied));
}

void Session::removeTargets(std::span<const TargetId> ids) {
    const std::vector<std::size_t> indices = indicesOf(ids);
    std::vector<TargetEdit> edits;
    std::for_each(indices.rbegin(), indices.rend(), [&](std::size_t index) {
        edits.push_back({index, TargetState(*m_targets[index]), std::nullopt});
    });
    if (!edits.empty()) {
        changeTargets(std::move(edits), {SessionUndo::Kind::RemoveTarget, indices.size()},
                      spliceOut(hitsOn(ids)));
    }
}

void Session::resetTargets(std::span<const TargetId> ids) {
    const std::vector<std::size_t> hits = hitsOn(ids);
    if (!hits.empty()) {
        changeHistory(spliceOut(hits), {SessionUndo::Kind::ResetTarget, indicesOf(ids).size()});
    }
}

Status Session::renameTarget(TargetId id, const QString& name) {
    const QString trimmed = name.simplified();
    if (trimmed.isEmpty()) {
        return Error{"A target needs a name.", "", "Type at least one letter."};
    }
    if (const Target* renamed = target(id); renamed != nullptr && renamed->name != trimmed) {
        TargetState after = *renamed;
        after.name = trimmed;
        changeTarget(*renamed, std::move(after), {SessionUndo::Kind::RenameTarget, 1});
    }
    return Done{};
}

void Session::setTargetsVisible(std::span<const TargetId> ids, bool visible) {
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
    changeTargets(std::move(edits),
                  {visible ? SessionUndo::Kind::ShowTarget : SessionUndo::Kind::HideTarget, count});
}

void Session::setTargetMaterials(std::span<const TargetId> ids, const std::shared_ptr<const MeshData>& mesh) {
    std::vector<TargetEdit> edits;
    for (const std::size_t index : indicesOf(ids)) {
        TargetState after = *m_targets[index];
        after.shape.mesh = mesh;
        edits.push_back({index, TargetState(*m_targets[index]), std::move(after)});
    }
    changeTargets(std::move(edits), {SessionUndo::Kind::TargetTexture, 1});
}

Status Session::setTargetTransform(TargetId id, const RigidTransform& transform, SessionUndo::Merge merge) {
    const float length = glm::length(transform.rotation);
    if (!isFinite(transform) || !(length > 1.0e-6f)) {
        return Error{"A target can only be put where its position and rotation are finite numbers.", "",
                     "Keep to the ranges the Scene panel shows."};
    }
    const Target* moved = target(id);
    if (moved == nullptr) {
        return Done{};
    }
    TargetState after = *moved;
    after.transform = {transform.position, transform.rotation / length};
    const bool turned = after.transform.rotation != moved->transform.rotation;
    if (turned || after.transform.position != moved->transform.position) {
        changeTarget(*moved, std::move(after),
                     {turned ? SessionUndo::Kind::RotateTarget : SessionUndo::Kind::MoveTarget, 1}, merge);
    }
    return Done{};
}

}  // namespace hitscope
