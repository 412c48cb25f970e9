// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>

#include "io/float_text.h"

namespace hitscope {

/// Appends the shortest text that reads back as the same number.
template <class Number>
void appendNumber(std::string& text, Number value) {
    char digits[32];  // enough for any double or 64-bit integer
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end);
}

/// The same for a float: writeFloat().
inline void appendTwiceRoundedFloat(std::string& text, float value) {
    char digits[kFloatText];
    text.append(digits, writeFloat(digits, value));
}

}  // namespace hitscope
