// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace hitscope {

using StlFacet = std::array<glm::vec3, 3>;

/// Of a binary file, in bytes: the header, with the number of facets; a facet, with normal, three vertices
/// and two bytes of attributes.
inline constexpr std::size_t kStlStart = 84;
inline constexpr std::size_t kStlFacetSize = 50;

/// The normal that is written with a facet, unit length; zero where it has no area.
inline glm::vec3 stlNormal(const StlFacet& facet) {
    const glm::dvec3 a(facet[0]);
    const glm::dvec3 across = glm::cross(glm::dvec3(facet[1]) - a, glm::dvec3(facet[2]) - a);
    const double length = glm::length(across);
    return length > 0.0 ? glm::vec3(across / length) : glm::vec3(0.0f);
}

}  // namespace hitscope
