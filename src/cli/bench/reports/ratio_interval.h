// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace hitscope::bench {

/// How many times as long something takes as something else.
struct RatioInterval {
    double ratio =
        0.0;  ///< the median of all quotients of a run of `b` and a run of `a` (Hodges and Lehmann)
    // The true ratio lies between these, with the confidence asked for; nothing: there are too few runs.
    std::optional<double> low;
    std::optional<double> high;
};

/// Of runs `b` over runs `a`, none empty, all above 0; 0.5 < confidence < 1. The interval is that of the
/// Wilcoxon-Mann-Whitney test on logarithms: order statistics of the quotients, with no assumption about how
/// the times are distributed but that both are alike apart from a factor (Hollander, Wolfe, Chicken,
/// "Nonparametric Statistical Methods", section 4.3). Exact up to 2,500 quotients, else by the normal
/// approximation. Of more than 1,000 runs 1,000 are taken, evenly spaced.
[[nodiscard]] RatioInterval ratioInterval(std::span<const double> a, std::span<const double> b,
                                          double confidence);

}  // namespace hitscope::bench
