// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace hitscope {

/// A number people can set, described once: the spin box, the command line and the checks all read it here.
struct ParameterDescriptor {
    std::string_view key;          ///< as in files and on the command line: "max_distance"
    std::string_view label;        ///< as in the interface: "Max distance"
    std::string_view unit;         ///< "m", "m/s", "" ...
    std::string_view description;  ///< one sentence for tool tips and help
    double defaultValue = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
    double step = 0.0;
    int decimals = 0;

    /// True when value is finite and within [minimum, maximum].
    [[nodiscard]] bool accepts(double value) const {
        return std::isfinite(value) && value >= minimum && value <= maximum;
    }
};

/// The decimal of fewest digits that reads back as the float: 0.3, not 0.30000001192. What a descriptor has
/// for a default that a float member is initialised with.
[[nodiscard]] double shortestDecimal(float value);

/// `parameters` with what `settings` has for defaults, so that these are written in one place. There is a
/// function parameterValue(settings, index).
template <class Settings, std::size_t Count>
[[nodiscard]] std::array<ParameterDescriptor, Count> withDefaultsOf(
    const Settings& settings, std::array<ParameterDescriptor, Count> parameters) {
    for (std::size_t i = 0; i < Count; ++i) {
        parameters[i].defaultValue = shortestDecimal(static_cast<float>(parameterValue(settings, i)));
    }
    return parameters;
}

}  // namespace hitscope
