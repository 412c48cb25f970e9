// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/face_measure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "mesh/triangulate.h"

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
    const double area = std::abs(measure.area);
    measure.isDegenerate = area <= kDegenerateWidth * longest * longest;
    const double corners = static_cast<double>(face.size());
    const double regular = 4.0 * std::tan(std::numbers::pi / corners);
    measure.aspect = measure.isDegenerate ? std::numeric_limits<double>::infinity()
                                          : longest * perimeter / (regular * area);
}

}  // namespace

FaceMeasure measureFace(std::span<const glm::vec3> positions, std::span<const std::uint32_t> face,
                        const glm::dvec3& reference) {
    FaceMeasure measure;
    measure.facing = doubleAreaVector(positions, face);
    const glm::dvec3 a = glm::dvec3(positions[face[0]]) - reference;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        const glm::dvec3 b = glm::dvec3(positions[face[i]]) - reference;
        const glm::dvec3 c = glm::dvec3(positions[face[i + 1]]) - reference;
        const glm::dvec3 doubleArea = glm::cross(b - a, c - a);
        const double area = 0.5 * glm::length(doubleArea);
        measure.area += glm::dot(doubleArea, measure.facing) < 0.0 ? -area : area;
        const double volume = glm::dot(a, glm::cross(b, c)) / 6.0;
        measure.volume += volume;
        measure.moment += volume * 0.25 * (a + b + c);
    }
    judgeShape(measure, positions, face);
    return measure;
}

}  // namespace hitscope
