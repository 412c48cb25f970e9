// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "view/change_options.h"

namespace hitscope {

/// A number beside a colour bar.
struct BarLabel {
    double value = 0.0;
    QString text;
};

/// The ends of a colour bar, low and high, and round numbers between them that keep `apart` from these, a
/// share of the bar's length. All are of one form: with an exponent if fixed ones would need too many
/// decimals.
[[nodiscard]] std::vector<BarLabel> barLabels(const ShownChange& change, double apart);

}  // namespace hitscope
