// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/change_options.h"

#include <cmath>

namespace hitscope {

std::array<QuantityStyle, kChangeQuantities> defaultQuantityStyles() {
    std::array<QuantityStyle, kChangeQuantities> styles;
    for (const ChangeTraits& traits : allChangeQuantities()) {
        QuantityStyle& style = styles[static_cast<std::size_t>(traits.quantity)];
        style.map = traits.isSigned ? ColourMap::CoolWarm : ColourMap::Viridis;
        style.fixed = {traits.isSigned ? -traits.usualLargest : 0.0f, traits.usualLargest};
    }
    return styles;
}

double niceStep(double low, double high, int parts) {
    const double least = (high - low) / parts;
    if (!(least > 0.0) || !std::isfinite(least)) {
        return 1.0;
    }
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

}  // namespace hitscope
