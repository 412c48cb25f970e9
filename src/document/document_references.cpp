// SPDX-License-Identifier: GPL-3.0-or-later
// What in a document names something else in it.
#include <algorithm>
#include <unordered_set>
#include <utility>

#include "document/document_parts.h"

namespace hitscope {

namespace {

constexpr const char* kAdvice = "It was changed by hand or by another program; mend it there.";

/// "hit 3", "target 1", "position 2": the member of the file without its plural, and the number in it from 1.
std::string place(const char* what, std::size_t index) {
    return std::string(what) + ' ' + std::to_string(index + 1);
}

std::string number(TargetId id) {
    return std::to_string(id.value);
}

Error noTarget(TargetId id, const std::string& where) {
    return {"It names target " + number(id) + ", which is not in the session.", where, kAdvice};
}

using Ids = std::unordered_set<TargetId>;

Ids idsOf(const SessionDocument& document) {
    Ids ids;
    for (const SavedTarget& target : document.targets) {
        ids.insert(target.id);
    }
    return ids;
}

Status checkSelection(const SavedSelection& selection, const Ids& ids, std::size_t hits) {
    const std::string where = "selection";
    if (selection.target && !ids.contains(selection.target)) {
        return noTarget(selection.target, where);
    }
    if (selection.picked && !ids.contains(selection.picked->target)) {
        return noTarget(selection.picked->target, where);
    }
    for (const SavedSelection::Vertices& vertices : selection.vertices) {
        if (!ids.contains(vertices.target)) {
            return noTarget(vertices.target, where);
        }
    }
    if ((selection.hit && *selection.hit >= hits) || (selection.shown && *selection.shown > hits)) {
        return Error{"It names a hit beyond the " + std::to_string(hits) + " that there are.", where,
                     kAdvice};
    }
    return Done{};
}

}  // namespace

Status checkIds(std::span<const SavedTarget> targets) {
    Ids ids;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (!ids.insert(targets[i].id).second) {
            return Error{"Another target has the id " + number(targets[i].id) + " too.", place("target", i),
                         kAdvice};
        }
    }
    return Done{};
}

void moveSection(Section section, SessionDocument& from, SessionDocument& to) {
    switch (section) {
        case Section::Scene:
            to.scene = std::move(from.scene);
            break;
        case Section::Targets:
            to.targets = std::move(from.targets);
            break;
        case Section::Constants:
            to.constants = from.constants;
            break;
        case Section::Projectile:
            to.projectile = from.projectile;
            break;
        case Section::Simulation:
            to.simulation = from.simulation;
            break;
        case Section::Lights:
            to.lights = from.lights;
            break;
        case Section::Cameras:
            to.cameras = std::move(from.cameras);
            break;
        case Section::Display:
            to.display = from.display;
            break;
        case Section::Selection:
            to.selection = std::move(from.selection);
            break;
        case Section::Positions:
            to.positions = std::move(from.positions);
            break;
        case Section::Hits:
            to.hits = std::move(from.hits);
            break;
    }
}

Status checkReferences(const SessionDocument& document) {
    if (Status unique = checkIds(document.targets); !unique) {
        return unique;
    }
    const Ids ids = idsOf(document);
    for (std::size_t i = 0; i < document.positions.size(); ++i) {
        if (!ids.contains(document.positions[i].target)) {
            return noTarget(document.positions[i].target, place("position", i));
        }
    }
    for (std::size_t i = 0; i < document.hits.size(); ++i) {
        if (!ids.contains(document.hits[i].target)) {
            return noTarget(document.hits[i].target, place("hit", i));
        }
    }
    return checkSelection(document.selection, ids, document.hits.size());
}

std::size_t dropDangling(SessionDocument& document) {
    const Ids ids = idsOf(document);
    const auto isGone = [&ids](const auto& named) { return !ids.contains(named.target); };
    SavedSelection& selection = document.selection;
    std::erase_if(document.positions, isGone);
    std::erase_if(selection.vertices, isGone);
    const std::size_t gone = std::erase_if(document.hits, isGone);
    if (!ids.contains(selection.target)) {
        selection.target = {};
    }
    if (selection.picked && isGone(*selection.picked)) {
        selection.picked.reset();
    }
    if (selection.hit && *selection.hit >= document.hits.size()) {
        selection.hit.reset();
    }
    if (selection.shown && *selection.shown > document.hits.size()) {
        selection.shown.reset();
    }
    return gone;
}

}  // namespace hitscope
