// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace hitscope::physics {

/// Corners in metres. In double, so that a step of many metres past a triangle of millimetres loses nothing.
struct Triangle {
    glm::dvec3 a{0.0};
    glm::dvec3 b{0.0};
    glm::dvec3 c{0.0};

    /// False for corners in a line or not finite: such a triangle is no surface. Relative to its size.
    [[nodiscard]] bool hasArea() const;
    [[nodiscard]] glm::dvec3 normal() const;  ///< unit, counter-clockwise side; only with an area
};

/// The three below take triangles with an area.
[[nodiscard]] glm::dvec3 nearestPoint(const Triangle& triangle, const glm::dvec3& from);

/// The fraction [0, 1] of `motion` at which a point crosses the triangle, from either side.
[[nodiscard]] std::optional<double> castPoint(const Triangle& triangle, const glm::dvec3& start,
                                              const glm::dvec3& motion);

/// The fraction [0, 1] of `motion` at which a sphere of `radius` > 0 first touches the triangle; 0 when it
/// overlaps it and goes deeper. Nothing when it never does, or moves away.
[[nodiscard]] std::optional<double> castSphere(const Triangle& triangle, const glm::dvec3& start,
                                               const glm::dvec3& motion, double radius);

/// Likewise for a sphere of `radius` >= 0 against a ball of `ballRadius` around `centre`.
[[nodiscard]] std::optional<double> castAtBall(const glm::dvec3& centre, double ballRadius,
                                               const glm::dvec3& start, const glm::dvec3& motion,
                                               double radius);

}  // namespace hitscope::physics
