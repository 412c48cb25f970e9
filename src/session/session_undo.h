// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "deform/hit_history.h"
#include "session/constants_setting.h"
#include "session/target_state.h"
#include "view/lights.h"

namespace hitscope {

/// A setting was one and became the other.
template <typename Value>
struct SettingEdit {
    Value before;
    Value after;
};

/// The steps a person can go back and forward through: changes of the hit history, of the deformation
/// constants of hits to come, of the targets and of the lights. A step costs what changed, not what there is.
class SessionUndo {
public:
    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    [[nodiscard]] bool canRedo() const { return !m_redo.empty(); }

    enum class Merge : std::uint8_t {
        Never,        ///< a step of its own
        WithSameKind  ///< with the last step, if that is of the same kind and about the same targets, and
                      ///< was neither undone nor finished in between
    };
    enum class Kind : std::uint8_t {
        Hit,
        Remove,
        Clear,
        Move,
        Enable,
        Disable,
        EditHit,
        HitConstants,  ///< of hits already made
        Constants,     ///< of the hits to come
        Lights,
        AddTarget,
        DuplicateTarget,
        RemoveTarget,
        MoveTarget,
        RotateTarget,
        RenameTarget,
        ShowTarget,
        HideTarget,
        ResetTarget,
        TargetPhysics,
        TargetTexture
    };
    /// What a step is called where it is offered to be undone.
    struct Name {
        Kind kind = Kind::Hit;
        std::size_t count = 1;  ///< hits or targets that it is about

        bool operator==(const Name&) const = default;
    };
    /// What one action of a person changed.
    struct Change {
        Name name = {};
        Merge merge = Merge::Never;
        std::vector<HistoryEdit> edits = {};   ///< in the order made
        std::vector<TargetEdit> targets = {};  ///< likewise
        std::optional<SettingEdit<ConstantsSetting>> constants = {};
        std::optional<SettingEdit<Lights>> lights = {};
    };
    /// Where nothing changed nothing is recorded; steps that merge and come to nothing go.
    void record(Change change);
    /// Nothing merges with the last step any more.
    void finishStep();
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

/// Makes one step of what a person does in one go: the first change of a part begins a step, further ones of
/// the same part merge with it until the gesture ends.
class UndoGesture {
public:
    /// Of a change of this part (>= 0): one slider, one box.
    [[nodiscard]] SessionUndo::Merge change(int part) {
        const bool goesOn = part == m_part;
        m_part = part;
        return goesOn ? SessionUndo::Merge::WithSameKind : SessionUndo::Merge::Never;
    }
    void end() { m_part = -1; }

private:
    int m_part = -1;
};

}  // namespace hitscope
