// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/bounds.h"
#include "view/camera.h"

namespace hitscope {

/// What a hand on the camera must not lose. World, metres.
struct SceneInSight {
    std::vector<Bounds> targets;          ///< of those that are shown
    std::optional<std::size_t> selected;  ///< among them
    std::optional<float> floor;           ///< its height; nothing: none is drawn
};

/// Whether some of the box is in the picture. `part`, in (0, 1], of the picture's width and height counts,
/// about its middle. Exact: a box beside a corner of the picture is not in it.
[[nodiscard]] bool isInPicture(const Bounds& box, const Camera& camera, float aspect, float part);

/// The box made smaller about its centre: what a shape of that size, as a sphere, fills.
[[nodiscard]] Bounds coreOf(const Bounds& box);

/// What to turn about where no surface is under the cursor: the centre of the selected target, or else of all
/// targets in the picture together. Nothing if that is not in the picture.
[[nodiscard]] std::optional<glm::vec3> centreInSight(const SceneInSight& scene, const Camera& camera,
                                                     float aspect);

/// The camera, pitched about `about` until its eye is no longer below `floor`; as it is if that cannot be.
[[nodiscard]] Camera raisedAbove(float floor, const Camera& camera, const glm::vec3& about);

}  // namespace hitscope
