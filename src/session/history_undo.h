// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "deform/hit_history.h"

namespace hitscope {

/// Steps back and forward through the changes of a hit history. Hits that were made cost a step only their
/// number; any other change keeps the history as it was before.
class HistoryUndo {
public:
    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    [[nodiscard]] bool canRedo() const { return !m_redo.empty(); }

    /// `count` hits were appended.
    void recordAppend(std::size_t count);

    enum class Merge : std::uint8_t {
        Never,
        WithSameKind  ///< with the last step, if that was recorded with WithSameKind too and nothing came
                      ///< between
    };
    /// `history` is about to change in another way; `constants` are those in force.
    void recordChange(const HitHistory& history, const DeformationConstants& constants,
                      Merge merge = Merge::Never);

    /// Takes the last change back; returns the constants that were in force then. canUndo().
    DeformationConstants undo(HitHistory& history, const DeformationConstants& constants);
    /// Makes the last change taken back again; canRedo().
    DeformationConstants redo(HitHistory& history, const DeformationConstants& constants);
    void clear();

private:
    struct Step {
        std::size_t appended = 0;  ///< > 0: this many hits were appended
        std::vector<Hit> hits;     ///< the appended hits while undone; else all hits on the step's other side
        DeformationConstants constants;
        Merge merge = Merge::Never;
    };
    static void swapWhole(Step& step, HitHistory& history, DeformationConstants& constants);

    std::vector<Step> m_undo;
    std::vector<Step> m_redo;
};

}  // namespace hitscope
