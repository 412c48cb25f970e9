// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene_gpu.h"
#include "session/target.h"

namespace hitscope {

/// What of a picture is drawn in one go: one of two side by side, one side of a wipe's line.
struct PicturePart {
    SceneGpu::View view;  ///< as if it were the only picture: neither side by side nor with a line within
    int left = 0;         ///< where its picture starts, pixels
    int from = 0;         ///< it covers the columns [from, to) of that picture
    int to = 0;
};

/// From left to right; they cover the picture.
[[nodiscard]] std::vector<PicturePart> partsOf(const SceneGpu::View& view);

/// Whether a part's view shows the targets as they were: a wipe's line at its right edge.
[[nodiscard]] bool showsOriginals(const SceneGpu::View& view);

/// How far within what the part's cutting plane leaves a vertex is drawn, metres; negative: it hides it.
/// Infinite without a plane.
[[nodiscard]] float shownBy(const SceneGpu::View& view, const Target& target, std::uint32_t vertex);

/// Where a vertex of the file is drawn in a part, in the target's local frame: where it was, or where it is,
/// as far exaggerated as the view says.
[[nodiscard]] glm::vec3 drawnPlace(const SceneGpu::View& view, const Target& target, std::uint32_t vertex);

}  // namespace hitscope
