// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace hitscope {

/// Axis-aligned box; empty until something is added.
struct Bounds {
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};

    [[nodiscard]] bool empty() const { return min.x > max.x; }
    void add(const glm::vec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const Bounds& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    /// Centre, size and diagonal are those of a point at the origin when the box is empty.
    [[nodiscard]] glm::vec3 centre() const { return empty() ? glm::vec3(0) : 0.5f * min + 0.5f * max; }
    [[nodiscard]] glm::vec3 size() const { return empty() ? glm::vec3(0) : max - min; }
    [[nodiscard]] float diagonal() const { return glm::length(size()); }
};

/// Bounding sphere. radius < 0: contains nothing.
struct Sphere {
    glm::vec3 centre{0.0f};
    float radius = -1.0f;
};

}  // namespace hitscope
