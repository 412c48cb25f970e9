// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
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

}  // namespace hitscope
