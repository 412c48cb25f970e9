// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/ids.h"
#include "render/pixel_area.h"

namespace hitscope {

/// What pixels can tell.
enum class PickElements : std::uint8_t {
    Triangles,  ///< the surface seen there
    Points      ///< the vertex that falls there, the nearest one to the eye, hidden by surfaces or not
};

/// What a pixel shows.
struct PickedElement {
    TargetId target;            ///< 0: none
    std::uint32_t element = 0;  ///< triangle or render vertex of its RenderMesh; of no target: kFilling

    /// No target, but the cutting plane's filling, which hides what lies behind it.
    static constexpr std::uint32_t kFilling = 1;
    [[nodiscard]] bool isFilling() const { return !target && element == kFilling; }

    bool operator==(const PickedElement&) const = default;
};

}  // namespace hitscope
