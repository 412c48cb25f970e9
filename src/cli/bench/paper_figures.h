// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>

namespace hitscope::bench {

/// Frames a second as the paper prints them, for its two laptops (section 3.1): L1 Core i7-6700HQ with a
/// GeForce GTX 950M, L2 Core i7-9750HQ with a GeForce GTX 1650.
struct PaperFigures {
    const char* l1;
    const char* l2;
};

/// A. Quercia, "Real Time Graphics Programming", table 1 (uniform arrays) and table 2 (transform feedback);
/// nine entries each, in the order of paperRows(). The paper does not say at which window size.
[[nodiscard]] std::span<const PaperFigures> paperTable1();
[[nodiscard]] std::span<const PaperFigures> paperTable2();

/// Of two of these figures, numbers or ranges of them ("60", "170-270"): how many times the frame rate of the
/// second the first is, from the lowest over the highest to the highest over the lowest; "x2.83-4.5", "x3".
[[nodiscard]] QString paperRatio(const char* rate, const char* over);

}  // namespace hitscope::bench
