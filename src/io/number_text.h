// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>

namespace hitscope {

/// Appends the shortest text that reads back as the same number.
template <class Number>
void appendNumber(std::string& text, Number value) {
    char digits[32];  // enough for any double or 64-bit integer
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end);
}

/// The same for a float that other programs may read as a double first and round then. Rarely, the shortest
/// text lies so close to the middle between two floats that rounding twice gives the wrong one; all digits
/// are written then.
inline void appendTwiceRoundedFloat(std::string& text, float value) {
    const std::size_t start = text.size();
    appendNumber(text, value);
    double read = 0.0;
    std::from_chars(text.data() + start, text.data() + text.size(), read);
    if (static_cast<float>(read) != value) {
        text.resize(start);
        appendNumber(text, static_cast<double>(value));
    }
}

}  // namespace hitscope
