// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deformation_constants.h"

namespace hitscope {

namespace {

// Without defaults, which the constants themselves have.
constexpr std::array<ParameterDescriptor, 3> kParameters{{
    {.key = "max_distance",
     .label = "Max distance",
     .unit = "m",
     .description = "Radius of the dent: vertices farther from the hit point stay where they are.",
     .minimum = 0.001,
     .maximum = 100.0,
     .step = 0.05,
     .decimals = 3},
    {.key = "power",
     .label = "Power",
     .unit = "m²",
     .description = "Strength of the hit: a vertex moves by power divided by its distance to the hit point.",
     .minimum = 0.0,
     .maximum = 100.0,
     .step = 0.005,
     .decimals = 4},
    {.key = "max_magnitude",
     .label = "Max magnitude",
     .unit = "m",
     .description = "Cap: no vertex moves farther than this in one hit.",
     .minimum = 0.0,
     .maximum = 100.0,
     .step = 0.05,
     .decimals = 3},
}};

}  // namespace

const std::array<ParameterDescriptor, 3>& deformationParameters() {
    static const auto parameters = withDefaultsOf(DeformationConstants{}, kParameters);
    return parameters;
}

const std::array<ParameterDescriptor, 3>& hitParameters() {
    constexpr double kLeastLength = 1.0e-9;  // metres
    constexpr double kMostLength = 1.0e9;    // metres
    constexpr double kMostPower = 1.0e18;    // square metres
    static const std::array<ParameterDescriptor, 3> parameters = [] {
        std::array<ParameterDescriptor, 3> wide = deformationParameters();
        wide[kMaxDistance].minimum = kLeastLength;
        wide[kMaxDistance].maximum = kMostLength;
        wide[kPower].maximum = kMostPower;
        wide[kMaxMagnitude].maximum = kMostLength;
        return wide;
    }();
    return parameters;
}

double parameterValue(const DeformationConstants& constants, std::size_t index) {
    switch (index) {
        case kMaxDistance:
            return constants.maxDistance;
        case kPower:
            return constants.power;
        default:
            return constants.maxMagnitude;
    }
}

void setParameterValue(DeformationConstants& constants, std::size_t index, double value) {
    const float number = static_cast<float>(value);
    switch (index) {
        case kMaxDistance:
            constants.maxDistance = number;
            break;
        case kPower:
            constants.power = number;
            break;
        default:
            constants.maxMagnitude = number;
            break;
    }
}

DeformationConstants scaled(const DeformationConstants& constants, float factor) {
    return {constants.maxDistance * factor, constants.power * factor * factor,
            constants.maxMagnitude * factor};
}

bool isValid(const DeformationConstants& constants) {
    const auto& parameters = deformationParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!parameters[i].accepts(parameterValue(constants, i))) {
            return false;
        }
    }
    return true;
}

}  // namespace hitscope
