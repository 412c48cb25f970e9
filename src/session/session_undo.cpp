// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_undo.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

/// Makes `earlier` do what it and then `later` do, where both replace the same hits; dragging a slider makes
/// hundreds of such.
bool absorbEdit(HistoryEdit& earlier, HistoryEdit& later) {
    if (earlier.first != later.first || earlier.after.size() != later.before.size()) {
        return false;
    }
    earlier.after = std::move(later.after);
    return true;
}

/// Whether each of `later` changes further what the same one of `earlier` changed, and adds or removes
/// nothing.
bool followOn(const std::vector<TargetEdit>& earlier, const std::vector<TargetEdit>& later) {
    return std::equal(earlier.begin(), earlier.end(), later.begin(), later.end(),
                      [](const TargetEdit& one, const TargetEdit& next) {
                          return one.before && one.after && next.before && next.after &&
                                 one.after->id == next.before->id;
                      });
}

/// Likewise where each of `later` changes further what the same one of `earlier` changed, as when several
/// hits are edited at once.
bool absorbEach(std::vector<HistoryEdit>& earlier, std::vector<HistoryEdit>& later) {
    const auto isSame = [](const HistoryEdit& one, const HistoryEdit& next) {
        return one.first == next.first && one.before.size() == one.after.size() &&
               one.after.size() == next.before.size() && next.before.size() == next.after.size();
    };
    if (!std::equal(earlier.begin(), earlier.end(), later.begin(), later.end(), isSame)) {
        return false;
    }
    for (std::size_t i = 0; i < later.size(); ++i) {
        earlier[i].after = std::move(later[i].after);
    }
    return true;
}

template <typename Value>
std::shared_ptr<const ValueEdit<Value>> inverse(const std::shared_ptr<const ValueEdit<Value>>& edit) {
    return edit ? std::make_shared<const ValueEdit<Value>>(ValueEdit<Value>{edit->after, edit->before})
                : nullptr;
}

/// Of those that merge: they change place and physics.
bool isSame(const TargetEdit& edit) {
    return edit.before && edit.after && edit.before->transform == edit.after->transform &&
           edit.before->physics == edit.after->physics;
}

bool comesToNothing(const SessionUndo::Change& change, bool isMerged) {
    const auto same = [](const HistoryEdit& edit) { return edit.before == edit.after; };
    const auto sameTarget = [isMerged](const TargetEdit& edit) { return isMerged && isSame(edit); };
    return std::all_of(change.targets.begin(), change.targets.end(), sameTarget) &&
           std::all_of(change.edits.begin(), change.edits.end(), same) &&
           (!change.settings || change.settings->before == change.settings->after) && !change.scene;
}

/// Meshes are shared by the steps they are in; they count where a step may be the last to hold them.
std::size_t bytesOf(const TargetState& target) {
    constexpr std::size_t kAVertex = 100;    // position, normal, file's own number
    constexpr std::size_t kATriangle = 100;  // corners, edges, the collider's tree
    return target.shape.mesh == nullptr ? 0
                                        : target.shape.mesh->positions.size() * kAVertex +
                                              target.shape.render->triangles.size() / 3 * kATriangle;
}

std::size_t bytesOf(const SceneState& scene) {
    std::size_t bytes = scene.hits.size() * sizeof(Hit);
    for (const TargetState& target : scene.targets) {
        bytes += bytesOf(target);
    }
    return bytes;
}

std::size_t bytesOf(const SessionUndo::Change& change) {
    std::size_t bytes = sizeof(change) + change.places.size() * sizeof(TargetPlace);
    for (const HistoryEdit& edit : change.edits) {
        bytes += sizeof(edit) + (edit.before.size() + edit.after.size()) * sizeof(Hit);
    }
    for (const TargetEdit& edit : change.targets) {
        const TargetState* only = edit.before && !edit.after ? &*edit.before : nullptr;
        only = edit.after && !edit.before ? &*edit.after : only;
        bytes += sizeof(edit) + (only != nullptr ? bytesOf(*only) : 0);
    }
    bytes += change.settings ? sizeof(*change.settings) : 0;
    return bytes + (change.scene ? bytesOf(change.scene->before) + bytesOf(change.scene->after) : 0);
}

UndoPart partChangedBy(const SessionUndo::Change& change) {
    switch (change.name.kind) {
        case SessionUndo::Kind::EditHit:
            return changedPart(change.edits);
        case SessionUndo::Kind::Constants:
            return change.settings
                       ? changedPart(change.settings->before.constants, change.settings->after.constants)
                       : UndoPart::None;
        case SessionUndo::Kind::CuttingPlane:
            return change.settings ? changedPart(change.settings->before.cut, change.settings->after.cut)
                                   : UndoPart::None;
        default:
            return UndoPart::None;
    }
}

/// Hits were made, as many as the name says, and nothing else: the history itself holds them.
bool onlyMadeHits(const SessionUndo::Change& change) {
    return change.edits.size() == 1 && change.edits[0].before.empty() &&
           change.edits[0].after.size() == change.name.count && change.targets.empty() && !change.settings &&
           !change.scene && change.places.empty();
}

SessionUndo::Change inverse(const SessionUndo::Change& change) {
    SessionUndo::Change undone;
    undone.name = change.name;
    std::for_each(change.edits.rbegin(), change.edits.rend(), [&undone](const HistoryEdit& edit) {
        undone.edits.push_back({edit.first, edit.after, edit.before});
    });
    std::for_each(change.targets.rbegin(), change.targets.rend(), [&undone](const TargetEdit& edit) {
        undone.targets.push_back({edit.index, edit.after, edit.before});
    });
    undone.settings = inverse(change.settings);
    undone.scene = inverse(change.scene);
    undone.selection = inverse(change.selection);
    return undone;
}

/// Returns `places`, which become the places of the same targets that there are `now`.
std::vector<TargetPlace> exchanged(std::vector<TargetPlace>& places, std::span<const TargetPlace> now) {
    std::vector<TargetPlace> before = places;
    for (TargetPlace& place : places) {
        const auto found = std::find_if(now.begin(), now.end(),
                                        [&place](const TargetPlace& other) { return other.id == place.id; });
        place = found != now.end() ? *found : place;
    }
    return before;
}

}  // namespace

std::size_t SessionUndo::Step::bytes() const {
    constexpr std::size_t kOneEdit = sizeof(Change) + sizeof(HistoryEdit);
    return sizeof(Step) + (change ? bytesOf(*change) : kOneEdit + name.count * sizeof(Hit));
}

std::size_t SessionUndo::bytesOfAll(std::span<const Step> steps) {
    std::size_t bytes = 0;
    for (const Step& step : steps) {
        bytes += step.bytes();
    }
    return bytes;
}

SessionUndo::Step SessionUndo::step(Change change, std::uint64_t number) {
    Step step;
    step.name = change.name;
    step.number = number;
    if ((change.merge == Merge::Never || change.name.kind == Kind::Stroke) && onlyMadeHits(change)) {
        step.first = change.edits[0].first;
    } else {
        step.change = std::make_unique<Change>(std::move(change));
    }
    return step;
}

/// Hits that come one by one, of one stroke.
bool SessionUndo::absorbHits(const Change& change) {
    Step& last = m_undo.back();
    const bool goesOn = !last.change && last.name.kind == change.name.kind && onlyMadeHits(change) &&
                        change.edits[0].first == last.first + last.name.count;
    last.name.count += goesOn ? change.name.count : 0;
    return goesOn;
}

bool SessionUndo::absorb(Change& change) {
    if (change.merge != Merge::WithSameKind || !canUndo() || m_undo.back().finished) {
        return false;
    }
    if (!m_undo.back().change) {
        return absorbHits(change);
    }
    Change& last = *m_undo.back().change;
    if (last.name.kind != change.name.kind || !followOn(last.targets, change.targets)) {
        return false;
    }
    if (!absorbEach(last.edits, change.edits)) {
        for (HistoryEdit& edit : change.edits) {
            if (last.edits.empty() || !absorbEdit(last.edits.back(), edit)) {
                last.edits.push_back(std::move(edit));
            }
        }
    }
    for (std::size_t i = 0; i < change.targets.size(); ++i) {
        const RigidTransform where = last.targets[i].after->transform;
        last.targets[i].after = std::move(change.targets[i].after);
        if (last.name.kind == Kind::TargetPhysics) {
            // It may have fallen in between, which undo and redo leave as it is.
            last.targets[i].after->transform = where;
        }
    }
    if (last.settings && change.settings) {
        last.settings = std::make_shared<const ValueEdit<SettingsState>>(
            ValueEdit<SettingsState>{last.settings->before, change.settings->after});
    }
    return true;
}

void SessionUndo::record(Change change) {
    std::erase_if(change.edits,
                  [](const HistoryEdit& edit) { return edit.before.empty() && edit.after.empty(); });
    if (comesToNothing(change, false)) {
        return;
    }
    change.name.part = partChangedBy(change);
    std::vector<Step> undone = std::exchange(m_redo, {});
    m_bytes -= bytesOfAll(undone);
    const std::size_t before = canUndo() ? m_undo.back().bytes() : 0;
    if (absorb(change)) {
        Step& last = m_undo.back();
        last.name.hit = last.name.hit == change.name.hit ? last.name.hit : 0;
        last.name.part = last.name.part == change.name.part ? last.name.part : UndoPart::None;
        m_bytes -= before;
        if (last.change && comesToNothing(*last.change, true)) {
            m_undo.pop_back();
            m_redo = std::exchange(m_aside, {});
            m_bytes += bytesOfAll(m_redo);
            finishStep();
            return;
        }
        last.number = ++m_last;
        m_bytes += last.bytes();
        return;
    }
    m_aside.clear();
    if (change.merge == Merge::WithSameKind) {
        m_aside = std::move(undone);
    }
    m_undo.push_back(step(std::move(change), ++m_last));
    if (m_undo.back().name.kind == Kind::LoadScene) {
        m_scenes.push_back(m_last);
    }
    m_bytes += m_undo.back().bytes();
    forgetOldest();
}

/// The last step is kept however large it is.
void SessionUndo::forgetOldest() {
    while (m_bytes > m_most && m_undo.size() > 1) {
        m_bytes -= m_undo.front().bytes();
        m_first = m_undo.front().number;
        if (m_undo.front().name.kind == Kind::LoadScene) {
            m_firstScene = m_first;
            m_scenes.erase(m_scenes.begin());
        }
        m_undo.pop_front();
        ++m_forgotten;
    }
}

const SessionUndo::Step& SessionUndo::stepAt(std::size_t step) const {
    return step < m_undo.size() ? m_undo[step] : m_redo[size() - 1 - step];
}

const SessionUndo::Name& SessionUndo::name(std::size_t step) const {
    return stepAt(step).name;
}

std::uint64_t SessionUndo::stateAfter(std::size_t step) const {
    return stepAt(step).number;
}

QString SessionUndo::target(std::size_t step) const {
    const std::unique_ptr<Change>& change = stepAt(step).change;
    if (!change || change->targets.empty()) {
        return {};
    }
    const auto nameOf = [](const TargetEdit& edit) {
        return edit.before ? edit.before->name : edit.after->name;
    };
    const QString name = nameOf(change->targets.front());
    const bool isOne = std::all_of(change->targets.begin(), change->targets.end(),
                                   [&](const TargetEdit& edit) { return nameOf(edit) == name; });
    return isOne ? name : QString();
}

std::optional<SessionUndo::Name> SessionUndo::toUndo() const {
    return canUndo() ? std::optional(m_undo.back().name) : std::nullopt;
}

std::optional<SessionUndo::Name> SessionUndo::toRedo() const {
    return canRedo() ? std::optional(m_redo.back().name) : std::nullopt;
}

void SessionUndo::finishStep() {
    m_aside.clear();
    if (canUndo()) {
        m_undo.back().finished = true;
    }
}

SessionUndo::Change SessionUndo::undo(std::span<const Hit> hits, const Places& places) {
    m_aside.clear();
    m_redo.push_back(std::move(m_undo.back()));
    m_undo.pop_back();
    Step& undone = m_redo.back();
    if (undone.name.kind == Kind::LoadScene) {
        m_scenes.pop_back();
    }
    if (!undone.change) {
        // From now on no history holds its hits.
        const std::span<const Hit> made = hits.subspan(undone.first, undone.name.count);
        undone.change = std::make_unique<Change>(
            Change{.name = undone.name, .edits = {{undone.first, {}, {made.begin(), made.end()}}}});
    }
    Change change = inverse(*undone.change);
    if (!undone.change->places.empty()) {
        change.places = exchanged(undone.change->places, places());
    }
    return change;
}

SessionUndo::Change SessionUndo::redo(const Places& places) {
    Change change = *m_redo.back().change;
    m_undo.push_back(step(change, m_redo.back().number));
    m_redo.pop_back();
    if (m_undo.back().name.kind == Kind::LoadScene) {
        m_scenes.push_back(m_undo.back().number);
    }
    if (!change.places.empty()) {
        change.places = exchanged(m_undo.back().change->places, places());
    }
    // Undone and made again, it is finished: a later change is a step of its own.
    m_undo.back().finished = true;
    return change;
}

void SessionUndo::clear() {
    m_undo.clear();
    m_redo.clear();
    m_aside.clear();
    m_scenes.clear();
    m_first = ++m_last;
    m_firstScene = m_first;
    m_bytes = 0;
    m_forgotten = 0;
}

}  // namespace hitscope
