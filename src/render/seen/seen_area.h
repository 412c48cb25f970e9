// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "core/bounds.h"
#include "render/pixel_area.h"

namespace hitscope::render {

/// Pixels that samples of a refined picture may reach around what its first picture shows: half of one for
/// their own offsets.
inline constexpr int kSampleReach = 2;

[[nodiscard]] std::array<glm::vec3, 8> cornersOf(const Bounds& box);

/// The part of a picture that boxes are seen in.
class SeenArea {
public:
    /// toClip: from the frame of the boxes to come.
    explicit SeenArea(const glm::mat4& toClip) : m_toClip(toClip) {}
    /// False: some of the box is not in front of the eye, and where it is seen is not known.
    [[nodiscard]] bool add(const Bounds& box);
    /// Of a picture of that size, pixels, with so many around it.
    [[nodiscard]] PixelArea in(const glm::ivec2& picture, int margin = kSampleReach) const;

    /// The nearest depth of any, as a depth buffer has it.
    [[nodiscard]] float nearest() const { return 0.5f * (m_bounds.min.z + 1.0f); }

private:
    glm::mat4 m_toClip;
    Bounds m_bounds;
};

}  // namespace hitscope::render
