// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

namespace hitscope {

/// The same numbers every time and everywhere, which the standard's distributions do not promise.
class TrialRandom {
public:
    explicit TrialRandom(std::uint32_t seed) : m_random(seed) {}

    /// [0, 1)
    float uniform() {
        constexpr unsigned kUnusedBits = 8;
        constexpr float kUnit = 0x1p-24f;
        return static_cast<float>(m_random() >> kUnusedBits) * kUnit;
    }
    /// [0, end), end > 0
    std::size_t below(std::size_t end) { return m_random() % end; }
    /// Of unit length.
    glm::vec3 direction() {
        glm::vec3 v(0.0f);
        float length2 = 0.0f;
        while (length2 < 0.01f || length2 > 1.0f) {
            for (glm::length_t i = 0; i < 3; ++i) {
                v[i] = 2.0f * uniform() - 1.0f;
            }
            length2 = glm::dot(v, v);
        }
        return glm::normalize(v);
    }

private:
    std::mt19937 m_random;
};

}  // namespace hitscope
