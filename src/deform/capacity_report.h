// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hitscope {

/// How full a pipeline is, and which hits of the history it no longer applies because of that.
struct CapacityReport {
    std::optional<std::size_t> capacity;  ///< most hits it keeps; nothing: any number
    bool perTarget = false;               ///< the capacity is each target's own, not the scene's
    std::size_t used = 0;                 ///< hits kept now; those of the fullest target if perTarget
    std::vector<std::size_t> dropped;     ///< indices into the history, ascending; enabled hits only
    bool byDriver = false;                ///< the driver has no room for as many as the pipeline would keep

    bool operator==(const CapacityReport&) const = default;
};

}  // namespace hitscope
