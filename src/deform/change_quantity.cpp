// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/change_quantity.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace hitscope {

namespace {

constexpr std::array<ChangeTraits, kChangeQuantities> kTraits{
    {{ChangeQuantity::Displacement, "displacement", "Displacement", "m",
      "How far the vertex is from where it was", false, true},
     {ChangeQuantity::AlongNormal, "along-normal", "Displacement along normal", "m",
      "Displacement along the original normal: negative is inwards", true, true},
     {ChangeQuantity::AlongX, "x", "Displacement in x", "m", "Displacement along the target's own x axis",
      true, true},
     {ChangeQuantity::AlongY, "y", "Displacement in y", "m", "Displacement along the target's own y axis",
      true, true},
     {ChangeQuantity::AlongZ, "z", "Displacement in z", "m", "Displacement along the target's own z axis",
      true, true},
     {ChangeQuantity::NormalRotation, "normal-rotation", "Normal rotation", "\u00b0",
      "Angle between the original normal and the paper's (equation 2)", false, true},
     {ChangeQuantity::TrueNormalError, "true-normal-error", "True-normal error", "\u00b0",
      "Angle between the paper's normal (equation 2) and that of the dented surface", false, true},
     {ChangeQuantity::HitCount, "hits", "Hits", "", "How many hits moved the vertex", false, false},
     {ChangeQuantity::EdgeStretch, "edge-stretch", "Edge stretch", "%",
      "Change in length of the vertex's edge that changed most: negative is shorter", true, false},
     {ChangeQuantity::Difference, "difference", "Difference of A and B", "m",
      "How far apart two pipelines have the vertex", false, false}}};

/// Degrees between two vectors; exact near 0 too, where a cosine is not.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace

std::span<const ChangeTraits> allChangeQuantities() {
    return kTraits;
}

const ChangeTraits& changeTraits(ChangeQuantity quantity) {
    return kTraits[static_cast<std::size_t>(quantity)];
}

double changeOf(ChangeQuantity quantity, const DynamicVertex& original, const DynamicVertex& current,
                const glm::vec3& trueNormal) {
    const glm::dvec3 moved = glm::dvec3(current.position) - glm::dvec3(original.position);
    switch (quantity) {
        case ChangeQuantity::Displacement:
            return glm::length(moved);
        case ChangeQuantity::AlongNormal:
            return glm::dot(moved, glm::dvec3(original.normal));
        case ChangeQuantity::AlongX:
            return moved.x;
        case ChangeQuantity::AlongY:
            return moved.y;
        case ChangeQuantity::AlongZ:
            return moved.z;
        case ChangeQuantity::NormalRotation:
            return angleBetween(original.normal, current.normal);
        case ChangeQuantity::TrueNormalError:
            return angleBetween(trueNormal, current.normal);
        default:
            return 0.0;
    }
}

}  // namespace hitscope
