// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/constants_setting.h"

#include <algorithm>
#include <cmath>

namespace hitscope {

float sizeFactor(float extent) {
    const double factor = static_cast<double>(extent) / kUsualExtent;
    if (!(factor > 0.0) || !std::isfinite(factor)) {
        return 1.0f;
    }
    // Rounded, so that one can read it, and so that a sphere whose corners miss 5 m by a bit counts as 5 m.
    const double unit = std::pow(10.0, std::floor(std::log10(factor)) - 2.0);
    return static_cast<float>(std::round(factor / unit) * unit);
}

namespace {

/// To six digits, so that 0.3 m on a target of 0.45 m is 0.027 m, and not the float next to it.
double withoutFloatNoise(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        return value;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 5.0);
    // Powers of ten below 1 are not exact: divide by their inverse, so that the result is the nearest to its
    // text.
    return unit < 1.0 ? std::round(value / unit) / std::round(1.0 / unit) : std::round(value / unit) * unit;
}

}  // namespace

DeformationConstants constantsOn(float extent, const ConstantsSetting& setting) {
    const float factor = setting.relative ? sizeFactor(extent) : 1.0f;
    DeformationConstants constants = factor == 1.0f ? setting.constants : scaled(setting.constants, factor);
    for (std::size_t i = 0; i < hitParameters().size(); ++i) {
        const ParameterDescriptor& range = hitParameters()[i];
        const double value =
            factor == 1.0f ? parameterValue(constants, i) : withoutFloatNoise(parameterValue(constants, i));
        setParameterValue(constants, i, std::clamp(value, range.minimum, range.maximum));
    }
    return constants;
}

}  // namespace hitscope
