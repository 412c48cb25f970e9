// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_targets.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "session/session.h"

namespace hitscope {

namespace {

/// "High-poly sphere 3" without its number.
QString stem(const QString& name) {
    const qsizetype space = name.lastIndexOf(u' ');
    bool isNumber = false;
    name.mid(space + 1).toUInt(&isNumber);
    return space > 0 && isNumber ? name.left(space) : name;
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

SessionTargets::SessionTargets(Session& session) : m_session(session) {}

// Finding

const Target* SessionTargets::find(TargetId id) const {
    const std::optional<std::size_t> index = indexOf(id);
    return index ? m_targets[*index].get() : nullptr;
}

std::optional<std::size_t> SessionTargets::indexOf(TargetId id) const {
    const auto found = std::find_if(m_targets.begin(), m_targets.end(),
                                    [id](const std::unique_ptr<Target>& target) { return target->id == id; });
    return found == m_targets.end() ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(found - m_targets.begin()));
}

/// Ascending, each once.
std::vector<std::size_t> SessionTargets::indicesOf(std::span<const TargetId> ids) const {
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

SessionTargets::Names SessionTargets::names() const {
    Names names;
    for (const std::unique_ptr<Target>& target : m_targets) {
        names.taken.insert(target->name);
    }
    return names;
}

QString SessionTargets::freeName(const QString& wanted, Names& names) {
    if (names.taken.insert(wanted).second) {
        return wanted;
    }
    const QString first = stem(wanted);
    int& number = names.next.try_emplace(first, 2).first->second;
    QString name;
    do {
        name = QStringLiteral("%1 %2").arg(first, QString::number(number++));
    } while (!names.taken.insert(name).second);
    return name;
}

Bounds SessionTargets::bounds() const {
    Bounds visible;
    Bounds all;
    for (const std::unique_ptr<Target>& target : m_targets) {
        const Bounds bounds = target->worldBounds();
        all.add(bounds);
        if (target->visible) {
            visible.add(bounds);
        }
    }
    return visible.empty() ? all : visible;
}

std::vector<TargetId> SessionTargets::allSelected() const {
    std::vector<TargetId> ids;
    for (const std::unique_ptr<Target>& target : m_targets) {
        if (isSelected(target->id)) {
            ids.push_back(target->id);
        }
    }
    return ids;
}

void SessionTargets::select(TargetId id, std::span<const TargetId> beside) {
    if (id && find(id) == nullptr) {
        return;
    }
    std::set<TargetId> others;
    std::copy_if(beside.begin(), beside.end(), std::inserter(others, others.end()),
                 [this, id](TargetId other) { return id && other != id && find(other) != nullptr; });
    if (id != m_selected || others != m_beside) {
        m_selected = id;
        m_beside = std::move(others);
        Q_EMIT selectedChanged(id);
        Q_EMIT m_session.pictureChanged();
    }
}

// Making

TargetState SessionTargets::newTarget(TargetPlan plan) {
    return stateOf(std::move(plan), TargetId{m_next++});
}

Target& SessionTargets::insert(std::size_t index, const TargetState& state) {
    const auto at = m_targets.begin() + static_cast<std::ptrdiff_t>(index);
    Target& target = **m_targets.insert(at, std::make_unique<Target>(state));
    m_session.m_simulation.add(target);
    return target;
}

void SessionTargets::erase(std::size_t index) {
    const TargetId id = m_targets[index]->id;
    m_session.m_simulation.forget(id);
    m_session.m_readBack->forget(id);
    m_targets.erase(m_targets.begin() + static_cast<std::ptrdiff_t>(index));
    if (m_selected == id) {
        select({});
    }
}

// Following a change

void SessionTargets::clear() {
    m_targets.clear();
    m_selected = {};
    m_beside.clear();
}

void SessionTargets::replace(std::vector<TargetPlan> plans, std::optional<float> floorHeight) {
    for (TargetPlan& plan : plans) {
        insert(m_targets.size(), newTarget(std::move(plan)));
    }
    if (m_targets.size() == 1) {
        m_selected = m_targets.front()->id;
    }
    if (floorHeight || m_targets.empty()) {
        m_floorHeight = floorHeight.value_or(0.0f);
        return;
    }
    m_floorHeight = std::numeric_limits<float>::max();
    for (const std::unique_ptr<Target>& target : m_targets) {
        m_floorHeight = std::min(m_floorHeight, floorUnder(target->worldBounds()));
    }
}

void SessionTargets::restore(std::span<const TargetState> states, float floorHeight, TargetId selected) {
    for (const TargetState& state : states) {
        insert(m_targets.size(), state);
        m_next = std::max(m_next, state.id.value + 1);
    }
    m_floorHeight = floorHeight;
    m_selected = selected;
}

void SessionTargets::follow(const TargetEdit& edit) {
    if (!edit.before) {
        const TargetId id = insert(edit.index, *edit.after).id;
        Q_EMIT added(id);
        select(id);
        return;
    }
    const TargetId id = edit.before->id;
    if (!edit.after) {
        erase(edit.index);
        const bool wasBeside = m_beside.erase(id) > 0;
        Q_EMIT removed(id);
        if (wasBeside) {
            // A list that still had it would select all others anew.
            Q_EMIT selectedChanged(m_selected);
        }
        return;
    }
    Target& target = *m_targets[edit.index];
    const RigidTransform where = target.transform;
    const bool isRenamed = edit.after->name != target.name;
    const bool isTextured = edit.after->shape.mesh != target.shape.mesh;
    static_cast<TargetState&>(target) = *edit.after;
    target.deformed.setMaterialsFrom(target.shape.mesh);
    const bool moves = edit.before->transform.position != target.transform.position ||
                       edit.before->transform.rotation != target.transform.rotation;
    if (moves || edit.before->visible != target.visible || edit.before->physics != target.physics) {
        m_session.m_simulation.letCollide(target);
    } else {
        // Knocked about since the change was noted down.
        target.transform = where;
    }
    Q_EMIT changed(id);
    if (isRenamed) {
        Q_EMIT renamed(id);
    }
    if (isTextured) {
        Q_EMIT textured(id);
    }
}

void SessionTargets::moveTo(TargetId id, const RigidTransform& transform) {
    Target& moved = *m_targets[*indexOf(id)];
    if (moved.transform.position != transform.position || moved.transform.rotation != transform.rotation) {
        moved.transform = transform;
        Q_EMIT changed(id);
    }
}

void SessionTargets::change(const SessionUndo::Change& change) {
    m_session.record(change);
    m_session.follow(change);
}

void SessionTargets::change(std::vector<TargetEdit> targets, SessionUndo::Name name,
                            std::vector<HistoryEdit> edits, SessionUndo::Merge merge) {
    if (!targets.empty() || !edits.empty()) {
        change({name, merge, std::move(edits), std::move(targets)});
    }
}

void SessionTargets::change(const Target& target, TargetState after, SessionUndo::Name name,
                            SessionUndo::Merge merge) {
    change({{*indexOf(target.id), TargetState(target), std::move(after)}}, name, {}, merge);
}

// What a person does

void SessionTargets::add(std::vector<TargetPlan> plans) {
    for (TargetPlan& plan : plans) {
        if (plan.sourcePath.isEmpty() && !bounds().empty()) {
            bringNear(plan, bounds(), m_floorHeight);
        }
    }
    makeRoom(plans, boundsOf(m_targets), m_floorHeight);
    Names takenNames = names();
    std::vector<TargetEdit> edits;
    for (TargetPlan& plan : plans) {
        plan.name = freeName(plan.name, takenNames);
        edits.push_back({m_targets.size() + edits.size(), std::nullopt, newTarget(std::move(plan))});
    }
    const std::size_t count = edits.size();
    change(std::move(edits), {SessionUndo::Kind::AddTarget, count});
}

void SessionTargets::putUnder(TargetId above, const RigidTransform& raised, TargetPlan plan) {
    const std::vector<std::size_t> at = indicesOf({&above, 1});
    if (at.empty()) {
        return;
    }
    Names takenNames = names();
    plan.name = freeName(plan.name, takenNames);
    const TargetState before = *m_targets[at.front()];
    TargetState after = before;
    after.transform = raised;
    std::vector<TargetEdit> edits;
    edits.push_back({at.front(), before, std::move(after)});
    edits.push_back({m_targets.size(), std::nullopt, newTarget(std::move(plan))});
    change(std::move(edits), {SessionUndo::Kind::PutOnTurntable, 1});
}

void SessionTargets::duplicate(std::span<const TargetId> ids) {
    std::vector<Bounds> taken = boundsOf(m_targets);
    Names takenNames = names();
    std::vector<TargetEdit> edits;
    std::vector<Hit> hits;
    for (const std::size_t index : indicesOf(ids)) {
        const Target& original = *m_targets[index];
        std::vector<TargetPlan> place(1);
        place.front().shape = original.shape;
        place.front().transform = original.transform;
        makeRoom(place, taken);
        TargetState copy = original;
        copy.id = TargetId{m_next++};
        copy.name = freeName(original.name, takenNames);
        copy.transform = place.front().transform;
        taken.push_back(worldBounds(*copy.shape.render, copy.transform));
        for (const Hit& hit : m_session.m_hits.history().hits()) {
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
    TargetSelection copies;
    for (const TargetEdit& edit : edits) {
        copies.beside.push_back(edit.after->id);
    }
    copies.target = copies.beside.back();
    std::vector<HistoryEdit> copied;
    if (!hits.empty()) {
        copied.push_back(m_session.m_hits.putIn(hits));
    }
    const SessionUndo::Name name{SessionUndo::Kind::DuplicateTarget, edits.size()};
    change({.name = name,
            .edits = std::move(copied),
            .targets = std::move(edits),
            .selection = std::make_shared<const ValueEdit<TargetSelection>>(
                ValueEdit<TargetSelection>{{m_selected, allSelected()}, std::move(copies)})});
}

void SessionTargets::remove(std::span<const TargetId> ids) {
    const std::vector<std::size_t> indices = indicesOf(ids);
    std::vector<TargetEdit> edits;
    std::for_each(indices.rbegin(), indices.rend(), [&](std::size_t index) {
        edits.push_back({index, TargetState(*m_targets[index]), std::nullopt});
    });
    if (!edits.empty()) {
        change(std::move(edits), {SessionUndo::Kind::RemoveTarget, indices.size()},
               m_session.m_hits.takeOut(m_session.m_hits.on(ids)));
    }
}

void SessionTargets::reset(std::span<const TargetId> ids) {
    const std::vector<std::size_t> hits = m_session.m_hits.on(ids);
    if (!hits.empty()) {
        m_session.m_hits.record(m_session.m_hits.takeOut(hits),
                                {SessionUndo::Kind::ResetTarget, indicesOf(ids).size()});
    }
}

}  // namespace hitscope
