// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "deform/hit_history.h"
#include "session/constants_setting.h"
#include "view/cutting_plane.h"

namespace hitscope {

/// The one thing that a step to undo changed of hits, of the constants or of the cutting plane, so that steps
/// of one kind can be told apart.
enum class UndoPart : std::uint8_t {
    None,  ///< several, or of another kind
    MaxDistance,
    Power,
    MaxMagnitude,
    PressRadius,
    Falloff,  ///< the profile or its curve
    Direction,
    Point,
    CutOn,
    CutOff,
    CutOffset,
    CutAxis,
    CutFlip,
    CutFill,
    CutLines
};

/// Of all hits that the edits change in place.
[[nodiscard]] UndoPart changedPart(std::span<const HistoryEdit> edits);
[[nodiscard]] UndoPart changedPart(const ConstantsSetting& before, const ConstantsSetting& after);
/// What brings others with it goes before them: a plane that is switched on may move, and so may one along
/// another axis.
[[nodiscard]] UndoPart changedPart(const CuttingPlane& before, const CuttingPlane& after);

}  // namespace hitscope
