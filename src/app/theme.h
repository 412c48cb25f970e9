// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <cstdint>

namespace hitscope {

enum class ThemeChoice : std::uint8_t { System, Light, Dark };

/// Sets the application's palette; System is what the desktop says.
void applyTheme(ThemeChoice choice);

/// True when text is lighter than the window behind it.
[[nodiscard]] bool isDark(const QPalette& palette);

}  // namespace hitscope
