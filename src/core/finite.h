// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/detail/qualifier.hpp>

namespace hitscope {

/// Whether all components are numbers, and not infinite.
template <glm::length_t L, class T, glm::qualifier Q>
[[nodiscard]] bool isFinite(const glm::vec<L, T, Q>& v) {
    for (glm::length_t i = 0; i < L; ++i) {
        if (!std::isfinite(v[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace hitscope
