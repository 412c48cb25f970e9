// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parameter.h"

#include <array>
#include <charconv>

namespace hitscope {

double shortestDecimal(float value) {
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    double decimal = static_cast<double>(value);
    std::from_chars(digits.data(), end, decimal);
    return decimal;
}

}  // namespace hitscope
