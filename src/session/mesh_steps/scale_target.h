// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/target_state.h"

namespace hitscope {

class Session;

/// A target in another size.
struct ScaledTarget {
    TargetState state;
    float factor = 1.0f;
    /// Metres, local frame: the middle of the lowest side of its box in the world, which stays where it is.
    glm::vec3 fixed{0.0f};
};

/// On any thread. `extent`: metres, the largest of the mesh then, as Target::extent() has it. The file's own
/// coordinates are kept for export. Errors: it is not positive, or the mesh has no size; the mesh was
/// refined, say, after it was read, which cannot be done again in another size.
[[nodiscard]] Result<ScaledTarget> scaledTo(const TargetState& target, double extent);

/// The target gets that size, as one step to undo. Its hits go along: their places, constants and radii are
/// scaled too, as far as the ranges of these go. Errors: the target is gone.
[[nodiscard]] Status takeScaled(Session& session, const ScaledTarget& scaled);

}  // namespace hitscope
