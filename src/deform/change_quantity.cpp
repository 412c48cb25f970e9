// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/change_quantity.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace hitscope {

namespace {

constexpr std::array<ChangeTraits, kChangeQuantities> kTraits{{
    {.quantity = ChangeQuantity::Displacement,
     .key = "displacement",
     .name = "Displacement",
     .unit = "m",
     .description = "How far the vertex is from where it was"},
    {.quantity = ChangeQuantity::AlongNormal,
     .key = "along-normal",
     .name = "Displacement along normal",
     .unit = "m",
     .description = "Displacement along the original normal: negative is inwards",
     .isSigned = true,
     .usesNormal = true},
    {.quantity = ChangeQuantity::AlongX,
     .key = "x",
     .name = "Displacement in x",
     .unit = "m",
     .description = "Displacement along the target's own x axis",
     .isSigned = true},
    {.quantity = ChangeQuantity::AlongY,
     .key = "y",
     .name = "Displacement in y",
     .unit = "m",
     .description = "Displacement along the target's own y axis",
     .isSigned = true},
    {.quantity = ChangeQuantity::AlongZ,
     .key = "z",
     .name = "Displacement in z",
     .unit = "m",
     .description = "Displacement along the target's own z axis",
     .isSigned = true},
    {.quantity = ChangeQuantity::NormalRotation,
     .key = "normal-rotation",
     .name = "Normal rotation",
     .unit = "\u00b0",
     .description = "Angle between the original normal and the paper's (equation 2)",
     .usesNormal = true,
     .usualLargest = 45.0f},
    {.quantity = ChangeQuantity::TrueNormalError,
     .key = "true-normal-error",
     .name = "True-normal error",
     .unit = "\u00b0",
     .description = "Angle between the paper's normal (equation 2) and that of the dented surface",
     .usesNormal = true,
     .isAlone = false,
     .usualLargest = 45.0f},
    {.quantity = ChangeQuantity::HitCount,
     .key = "hits",
     .name = "Hits",
     .unit = "",
     .description = "How many hits moved the vertex",
     .inShader = false,
     .usualLargest = 10.0f},
    {.quantity = ChangeQuantity::EdgeStretch,
     .key = "edge-stretch",
     .name = "Edge stretch",
     .unit = "%",
     .description = "Change in length of the vertex's edge that changed most: negative is shorter",
     .isSigned = true,
     .inShader = false,
     .isAlone = false,
     .usualLargest = 100.0f},
    {.quantity = ChangeQuantity::Difference,
     .key = "difference",
     .name = "Difference of A and B",
     .unit = "m",
     .description = "How far apart two pipelines have the vertex",
     .inShader = false,
     .isAlone = false,
     .usualLargest = 0.1f},
}};

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
