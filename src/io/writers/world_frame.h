// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace hitscope {

/// Takes a target's positions and normals from its local frame to the world.
class WorldFrame {
public:
    /// transform: local frame to world, metres.
    explicit WorldFrame(const glm::dmat4& transform)
        : m_transform(transform),
          m_turn(glm::transpose(glm::inverse(glm::dmat3(transform)))),
          m_isTurned(glm::dmat3(transform) != glm::dmat3(1.0)) {}

    [[nodiscard]] bool isTurned() const { return m_isTurned; }
    [[nodiscard]] glm::vec3 position(const glm::vec3& local) const {
        return glm::vec3(m_transform * glm::dvec4(glm::dvec3(local), 1.0));
    }
    /// Unit length if it turns; what has no direction stays as it is.
    [[nodiscard]] glm::vec3 normal(const glm::vec3& local) const {
        const glm::dvec3 now = m_turn * glm::dvec3(local);
        const double length = glm::length(now);
        return m_isTurned && length > 0.0 ? glm::vec3(now / length) : local;
    }

private:
    glm::dmat4 m_transform;
    glm::dmat3 m_turn;
    bool m_isTurned;
};

}  // namespace hitscope
