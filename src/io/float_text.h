// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace hitscope {

/// Bytes that a float's text takes at most, and some more that writing it may use.
inline constexpr std::size_t kFloatText = 40;

/// Writes the shortest text that reads back as the same float, and is the nearest of its length to it, as
/// std::to_chars() does; returns its end. Where other programs, which may read a double first and round
/// then, would get another float from it (rarely: it lies close to the middle between two floats), it has all
/// digits of the float. `to` has room for kFloatText bytes.
char* writeFloat(char* to, float value);

/// Writes a number between -10 and 10 with six decimals at most: "-0.25", "0.707107". Others as writeFloat()
/// does. Returns its end; `to` has room for kFloatText bytes. For what is computed and only shaded with, such
/// as normals: it is off by half a millionth at most.
char* writeSixDecimals(char* to, float value);

}  // namespace hitscope
