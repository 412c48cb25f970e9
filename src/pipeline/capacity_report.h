// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hitscope {

/// What a pipeline keeps of the history, where it cannot keep all.
struct CapacityReport {
    std::optional<std::size_t> capacity;  ///< most hits kept; nothing: unlimited
    bool perTarget = false;               ///< capacity is that of each target, not of the scene
    std::size_t used = 0;                 ///< hits kept; per target: of the target with the most
    std::vector<std::size_t> dropped;     ///< indices into the history of enabled hits not kept, ascending

    bool operator==(const CapacityReport&) const = default;
};

}  // namespace hitscope
