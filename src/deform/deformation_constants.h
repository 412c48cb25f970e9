// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/parameter.h"

namespace hitscope {

/// The three constants of the paper's deformation function (section 2.3).
struct DeformationConstants {
    float maxDistance = 0.5f;   ///< metres: the function is applied where r <= maxDistance
    float power = 0.05f;        ///< square metres: magnitude is power / r
    float maxMagnitude = 0.3f;  ///< metres: magnitude is never more

    bool operator==(const DeformationConstants&) const = default;
};

/// Which constant: an index into deformationParameters() and hitParameters().
inline constexpr std::size_t kMaxDistance = 0;
inline constexpr std::size_t kPower = 1;
inline constexpr std::size_t kMaxMagnitude = 2;
/// max_distance, power, max_magnitude, in this order.
[[nodiscard]] const std::array<ParameterDescriptor, 3>& deformationParameters();
[[nodiscard]] double parameterValue(const DeformationConstants& constants, std::size_t index);
void setParameterValue(DeformationConstants& constants, std::size_t index, double value);

/// True when every constant is within its descriptor's range.
[[nodiscard]] bool isValid(const DeformationConstants& constants);

/// The same constants with the ranges that a hit may have: wide enough for those of a target of 0.1 mm or of
/// 1,000 km, narrow enough that nothing overflows.
[[nodiscard]] const std::array<ParameterDescriptor, 3>& hitParameters();

/// For a target `factor` (> 0) times as large: the same dent, as many times as large.
[[nodiscard]] DeformationConstants scaled(const DeformationConstants& constants, float factor);

}  // namespace hitscope
