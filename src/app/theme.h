// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <cstdint>

class QStyle;

namespace hitscope {

enum class ThemeChoice : std::uint8_t { System, Light, Dark };

/// The style that the window is drawn for; the same on every desktop. The caller owns it.
[[nodiscard]] QStyle* makeStyle();

/// Sets the application's palette; System is what the desktop says.
void applyTheme(ThemeChoice choice);

/// True when text is lighter than the window behind it.
[[nodiscard]] bool isDark(const QPalette& palette);

}  // namespace hitscope
