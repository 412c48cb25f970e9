// SPDX-License-Identifier: GPL-3.0-or-later
// How a summary of values becomes a colour map's range.
#include <algorithm>
#include <cmath>

#include "analysis/change_values.h"

namespace hitscope {

ChangeRange shownRange(const ChangeMapOptions& options, const Summary& summary) {
    const QuantityStyle& style = options.style();
    if (!style.automatic) {
        return style.fixed;
    }
    if (summary.count == 0) {
        return defaultQuantityStyles()[static_cast<std::size_t>(options.quantity)].fixed;
    }
    const double largest = std::max(std::abs(summary.low), std::abs(summary.high));
    const auto end = static_cast<float>(largest > 0.0 ? largest : 1e-6);
    return {changeTraits(options.quantity).isSigned ? -end : 0.0f, end};
}

ShownChange shownChange(const ChangeMapOptions& options, const Summary& summary) {
    ShownChange shown{options.quantity, options.style().map, shownRange(options, summary), 0.0f};
    if (options.isolines) {
        shown.isolineStep = static_cast<float>(
            niceStep(static_cast<double>(shown.range.low), static_cast<double>(shown.range.high), kIsolines));
    }
    return shown;
}

}  // namespace hitscope
