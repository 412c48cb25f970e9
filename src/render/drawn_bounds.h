// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "render/renderer.h"

namespace hitscope::render {

/// A part of a picture, in [-1, 1]^2, y up.
struct PictureWindow {
    glm::vec2 low{-1.0f};
    glm::vec2 high{1.0f};
};

/// Whether some of the target may be drawn within the window; true where that is not known.
[[nodiscard]] bool mayShow(const DrawItem& item, const Frame& frame, const DeformationPipeline& pipeline,
                           const glm::mat4& viewProjection, const PictureWindow& window);

}  // namespace hitscope::render
