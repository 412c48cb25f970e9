// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deform/hit.h"

namespace hitscope {

class Session;

/// What a hit like this one is made with now: the constants by its target's size and, where power follows the
/// impulse, by its impulse.
[[nodiscard]] DeformationConstants usualConstants(const Session& session, const Hit& hit);
/// Likewise the form, as withRadius() has it.
[[nodiscard]] DentForm usualForm(const Session& session, const Hit& hit, float radius = 0.0f);
/// `form` with the radius of a hit that presses: `radius` (metres); 0: the hit's own, or that of the
/// projectiles now.
[[nodiscard]] DentForm withRadius(const Session& session, DentForm form, const Hit& hit, float radius = 0.0f);

}  // namespace hitscope
