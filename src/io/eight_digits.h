// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace hitscope {

inline constexpr std::uint32_t kMostOfEightDigits = 99'999'999;

/// The eight decimal digits of a number of at most kMostOfEightDigits, as numbers from 0 to 9: the first in
/// the lowest byte. Halves, then quarters, then eighths are divided at once, each by a product and a shift
/// that are exact for so small numbers.
inline std::uint64_t eightDigits(std::uint32_t number) {
    const std::uint64_t fours = number / 10'000 | std::uint64_t{number % 10'000} << 32;
    const std::uint64_t hundreds = (fours * 5243 >> 19) & 0x0000007f'0000007fu;
    const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
    const std::uint64_t tens = (twos * 103 >> 10) & 0x000f000f'000f000fu;
    return tens | (twos - 10 * tens) << 8;
}

/// Writes eight digits, as eightDigits() gives them, as text.
inline void storeDigits(char* to, std::uint64_t digits) {
    digits |= 0x3030303030303030u;
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(to, &digits, sizeof digits);
    } else {
        for (int i = 0; i < 8; ++i) {
            to[i] = static_cast<char>(digits >> 8 * i);
        }
    }
}

/// Writes a number of at most kMostOfEightDigits and returns its end; may write up to eight bytes.
inline char* writeShortNumber(char* to, std::uint32_t number) {
    const std::uint64_t digits = eightDigits(number);
    const int zeros = std::countr_zero(digits | std::uint64_t{1} << 56) / 8;  // before the first digit
    storeDigits(to, digits >> 8 * zeros);
    return to + (8 - zeros);
}

}  // namespace hitscope
