// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deform/deformation_constants.h"
#include "deform/dent_form.h"

namespace hitscope {

/// The deformation constants, and the form of dents, that a session's shots are made with.
struct ConstantsSetting {
    DeformationConstants constants;  ///< as set; where they are relative, those of a target of kUsualExtent
    /// Dents grow and shrink with the target, so that a mesh of any size dents as the paper's targets do.
    bool relative = true;
    /// Of the dents; whatever has no part in it now is kept for when it has. The radius is each shot's.
    DentForm form = {};

    bool operator==(const ConstantsSetting&) const = default;
};

/// Metres: the largest extent of the paper's targets, for which its constants are made.
inline constexpr float kUsualExtent = 5.0f;

/// How many times kUsualExtent a target of that extent (metres) is, to three digits; 1 for a single point.
[[nodiscard]] float sizeFactor(float extent);

/// What the setting comes to on a target of that extent (metres); within hitParameters().
[[nodiscard]] DeformationConstants constantsOn(float extent, const ConstantsSetting& setting);

}  // namespace hitscope
