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
    /// What one action of a person changed. A change of the history: without one nothing is recorded.
    struct Change {
        std::vector<HistoryEdit> edits;  ///< in the order made
        DeformationConstants constantsBefore;
        DeformationConstants constantsAfter;
        Merge merge = Merge::Never;
    };
    void record(Change change);

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
