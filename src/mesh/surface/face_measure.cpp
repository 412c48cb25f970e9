// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/face_measure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace hitscope {

namespace {

constexpr double kDegenerateWidth = 1.0e-6;  // of the longest edge

void judgeShape(FaceMeasure& measure, std::span<const glm::vec3> positions,
                std::span<const std::uint32_t> face) {
    double longest = 0.0;
    double perimeter = 0.0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::dvec3 from(positions[face[i]]);
        const glm::dvec3 to(positions[face[i + 1 < face.size() ? i + 1 : 0]]);
        const double length = glm::length(to - from);
        longest = std::max(longest, length);
        perimeter += length;
    }
    measure.isDegenerate = measure.area <= kDegenerateWidth * longest * longest;
    const double corners = static_cast<double>(face.size());
    const double regular = 4.0 * std::tan(std::numbers::pi / corners);
    measure.aspect = measure.isDegenerate ? std::numeric_limits<double>::infinity()
                                          : longest * perimeter / (regular * measure.area);
}

}  // namespace

FaceMeasure FaceMeasurer::measure(std::span<const glm::vec3> positions, std::span<const std::uint32_t> face,
                                  const glm::dvec3& reference) {
    m_corners.clear();
    m_triangulator.triangulate(m_originals, face, m_corners);
    FaceMeasure measure;
    for (std::size_t t = 0; t < m_corners.size(); t += 3) {
        const auto at = [&](std::size_t corner) {
            return glm::dvec3(positions[face[m_corners[t + corner]]]);
        };
        measure.area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
        const glm::dvec3 a = at(0) - reference;
        const glm::dvec3 b = at(1) - reference;
        const glm::dvec3 c = at(2) - reference;
        const double volume = glm::dot(a, glm::cross(b, c)) / 6.0;
        measure.volume += volume;
        measure.moment += volume * 0.25 * (a + b + c);
    }
    judgeShape(measure, positions, face);
    return measure;
}

}  // namespace hitscope
