// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <glm/vec3.hpp>

namespace hitscope {

inline constexpr double kMilliseconds = 1000.0;  ///< in a second: what is shown counts in them

/// "7,938", grouped as the locale does. Further numbers for the window: session/shown_number.h.
[[nodiscard]] QString countText(std::size_t count);

/// A measured number with five significant digits where nine characters hold them: "12.566", "0.30000",
/// "0.001054", "0.000105", "1.05e-05".
[[nodiscard]] QString quantityText(double value);
/// Likewise in a locale (shown_number.h).
[[nodiscard]] QString quantityText(const QLocale& locale, double value);

/// Three coordinates with three decimals, "1.250, -0.300, 0.000", or "1,250; -0,300; 0,000"; where all are
/// small, with as many as show the largest: "0.0123, 0.0000, -0.0005", "1.05e-05, 0.00e+00, 2.00e-06".
[[nodiscard]] QString vectorText(const glm::vec3& vector);

/// The same for what is copied or saved: with points in every locale.
[[nodiscard]] QString copiedVectorText(const glm::vec3& vector);

}  // namespace hitscope
