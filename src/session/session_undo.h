// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "deform/hit_history.h"
#include "session/constants_setting.h"
#include "session/target_state.h"

namespace hitscope {

/// The steps a person can go back and forward through: changes of the hit history, of the deformation
/// constants in force and of the targets. A step costs what changed, not what there is.
class SessionUndo {
public:
    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    [[nodiscard]] bool canRedo() const { return !m_redo.empty(); }

    enum class Merge : std::uint8_t {
        Never,
        WithSameKind  ///< with the last step, if that is of the same kind and about the same targets, and
                      ///< was not undone in between
    };
    enum class Kind : std::uint8_t {
        Hit,
        Remove,
        Clear,
        Move,
        Enable,
        Disable,
        Constants,
        AddTarget,
        DuplicateTarget,
        RemoveTarget,
        MoveTarget,
        RotateTarget,
        RenameTarget,
        ShowTarget,
        HideTarget,
        ResetTarget,
        TargetPhysics
    };
    /// What a step is called where it is offered to be undone.
    struct Name {
        Kind kind = Kind::Hit;
        std::size_t count = 1;  ///< hits or targets that it is about

        bool operator==(const Name&) const = default;
    };
    /// What one action of a person changed.
    struct Change {
        std::vector<HistoryEdit> edits;  ///< in the order made
        ConstantsSetting constantsBefore;
        ConstantsSetting constantsAfter;
        Merge merge = Merge::Never;
        Name name = {};
        std::vector<TargetEdit> targets = {};  ///< in the order made
    };
    /// Without a change of the history or of a target nothing is recorded.
    void record(Change change);
    /// What undo() or redo() would take back or make again; null: nothing.
    [[nodiscard]] const Change* toUndo() const { return canUndo() ? &m_undo.back().change : nullptr; }
    [[nodiscard]] const Change* toRedo() const { return canRedo() ? &m_redo.back().change : nullptr; }

    /// What to do to take the last change back. canUndo().
    [[nodiscard]] Change undo();
    /// What to do to make the last change taken back again. canRedo().
    [[nodiscard]] Change redo();
    void clear();

private:
    struct Step {
        Change change;
        bool finished = false;  ///< nothing merges with it any more
    };
    bool absorb(Change& change);

    std::vector<Step> m_undo;
    std::vector<Step> m_redo;
};

}  // namespace hitscope
