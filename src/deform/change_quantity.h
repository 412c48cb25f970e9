// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "mesh/render_mesh.h"

namespace hitscope {

/// What can be said about the change of a vertex in one number.
enum class ChangeQuantity : std::uint8_t {
    Displacement,     ///< length, metres
    AlongNormal,      ///< along the original normal, metres: negative is inwards
    AlongX,           ///< in the target's own frame, metres
    AlongY,           ///< likewise
    AlongZ,           ///< likewise
    NormalRotation,   ///< from the original normal to the paper's (eq. 2), degrees
    TrueNormalError,  ///< from the dented surface's normal to the paper's, degrees
    HitCount,         ///< hits that moved the vertex
    EdgeStretch,      ///< of the vertex's edge whose length changed most, percent: negative is shorter
    Difference,       ///< from where a second pipeline has the vertex, metres
};
inline constexpr int kChangeQuantities = 10;

struct ChangeTraits {
    ChangeQuantity quantity = ChangeQuantity::Displacement;
    std::string_view key;          ///< in settings: "displacement"
    std::string_view name;         ///< as in the interface
    std::string_view unit;         ///< empty: a plain number
    std::string_view description;  ///< one sentence
    bool isSigned = false;
    bool inShader = true;       ///< change.glsl finds it from the vertex alone; else it comes in a buffer
    bool usesNormal = false;    ///< a vertex that is drawn with several normals has several values
    bool isAlone = true;        ///< a vertex that did not move has none, whatever its neighbours did
    float usualLargest = 0.5f;  ///< the end of a range that a few hits fill
};

/// Every quantity, in the order of the enumeration.
[[nodiscard]] std::span<const ChangeTraits> allChangeQuantities();
[[nodiscard]] const ChangeTraits& changeTraits(ChangeQuantity quantity);

/// A quantity that is inShader, as change.glsl finds it. `trueNormal`: of the dented surface, unit.
[[nodiscard]] double changeOf(ChangeQuantity quantity, const DynamicVertex& original,
                              const DynamicVertex& current, const glm::vec3& trueNormal);

}  // namespace hitscope
