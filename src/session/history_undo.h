// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "deform/hit_history.h"

namespace hitscope {

/// Steps back and forward through the changes of a hit history, and of the deformation constants in force. A
/// step costs what changed, not what there is.
class HistoryUndo {
public:
    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    [[nodiscard]] bool canRedo() const { return !m_redo.empty(); }

    enum class Merge : std::uint8_t {
        Never,
        WithSameKind  ///< with the last step, if that was recorded with WithSameKind too and nothing came
                      ///< between
    };
    enum class Kind : std::uint8_t { Hit, Remove, Clear, Move, Enable, Disable, Constants };
    /// What a step is called where it is offered to be undone.
    struct Name {
        Kind kind = Kind::Hit;
        std::size_t hits = 1;  ///< that it is about

        bool operator==(const Name&) const = default;
    };
    /// What one action of a person changed. A change of the history: without one nothing is recorded.
    struct Change {
        std::vector<HistoryEdit> edits;  ///< in the order made
        DeformationConstants constantsBefore;
        DeformationConstants constantsAfter;
        Merge merge = Merge::Never;
        Name name = {};
    };
    void record(Change change);
    /// What undo() or redo() would take back or make again; null: nothing.
    [[nodiscard]] const Change* toUndo() const { return canUndo() ? &m_undo.back() : nullptr; }
    [[nodiscard]] const Change* toRedo() const { return canRedo() ? &m_redo.back() : nullptr; }

    /// Takes the last change back; returns the constants that were in force then. canUndo().
    DeformationConstants undo(HitHistory& history);
    /// Makes the last change taken back again; returns the constants then in force. canRedo().
    DeformationConstants redo(HitHistory& history);
    void clear();

private:
    std::vector<Change> m_undo;
    std::vector<Change> m_redo;
};

}  // namespace hitscope
