// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "view/display_options.h"

namespace hitscope::bench {

/// A way to look at a scene, and what it may cost.
struct ViewMode {
    /// Where from: all of the scene; or one target, so near that vertices and edges can be told apart.
    enum class Place : std::uint8_t { Overview, Close };
    /// What else there is to it than options.
    enum class Extra : std::uint8_t {
        None,
        Comparison,  ///< a second pipeline
        Metal,       ///< all targets' material has metalness and roughness
        Selection,   ///< all changed vertices selected, one picked, one hovered
        Preview,     ///< the dent that a shot would make
        Picking,     ///< each frame asks what is under the cursor
    };

    const char* key;   ///< "wire-only"; the check is "mode-wire-only"
    const char* name;  ///< "wireframe only"
    void (*set)(DisplayOptions& options) = [](DisplayOptions&) {};
    Place place = Place::Overview;
    Extra extra = Extra::None;
    double atMost = 1.5;  ///< of a plainly shaded frame from the same place
};

/// All of them. The first of a place is plain shading.
[[nodiscard]] std::span<const ViewMode> viewModes();
/// What `mode` is held against.
[[nodiscard]] const ViewMode& plainModeOf(const ViewMode& mode);

}  // namespace hitscope::bench
