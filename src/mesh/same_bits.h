// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <glm/vec3.hpp>

namespace hitscope {

/// Equal to the last bit: -0 is not 0, and a NaN is itself.
inline bool sameBits(const glm::vec3& a, const glm::vec3& b) {
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace hitscope
