// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/float_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "io/eight_digits.h"

namespace hitscope {
namespace {

constexpr int kLongest = 8;  // digits, here; a float may need nine

constexpr auto kPowers = [] {
    std::array<double, 16> powers{};
    double power = 1.0;
    for (double& one : powers) {
        one = power;
        power *= 10.0;
    }
    return powers;
}();

/// 0.DIGITS * 10^exponent
struct Decimal {
    std::uint32_t digits = 0;  // eight, the first not 0
    int count = 0;             // of those that matter; zeros follow
    int exponent = 0;
};

char* writeSlowly(char* to, float value) {
    char* end = std::to_chars(to, to + kFloatText, value).ptr;
    double read = 0.0;
    std::from_chars(to, end, read);
    if (static_cast<float>(read) != value) {
        end = std::to_chars(to, to + kFloatText, static_cast<double>(value)).ptr;
    }
    return end;
}

/// value * 10^scale, and what decides about digits of it.
struct Scaled {
    double number = 0.0;  // [1e8, 1e9): as good as exact, since a float has 29 bits less than a double
    double half = 0.0;    // of the gap between floats here: what is nearer than this reads as the value
    int scale = 0;

    [[nodiscard]] double awayFrom(std::uint32_t digits, double step) const {
        return std::abs(number - step * static_cast<double>(digits));
    }
    /// So close to `bound` that the last bits of doubles would decide.
    [[nodiscard]] static bool isUnsure(double away, double bound) { return std::abs(away - bound) < 1e-4; }
};

/// number / divisor, rounded; either neighbour where it is as good as in the middle.
std::uint32_t nearest(double number, double inverse) {
    return static_cast<std::uint32_t>(number * inverse + 0.5);
}

/// How many of the eight digits of a number that ends in a zero matter, and these.
bool shorten(const Scaled& scaled, Decimal& decimal) {
    for (double step = 1000.0; step < 1e9; step *= 10.0) {
        const std::uint32_t digits = nearest(scaled.number, 1.0 / step);
        const double away = scaled.awayFrom(digits, step);
        if (Scaled::isUnsure(away, scaled.half) || (away < scaled.half && Scaled::isUnsure(away, step / 2))) {
            return false;
        }
        if (away > scaled.half) {
            break;
        }
        --decimal.count;
        decimal.digits = digits * static_cast<std::uint32_t>(step / 10.0);
    }
    return true;
}

/// value: of [1e-5, 1e7). False where it needs nine digits or these cannot be told with certainty.
bool shortest(float value, Decimal& decimal) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    if ((bits & 0x7fffffu) == 0) {
        return false;  // the gap below is narrower than that above
    }
    const int binary = static_cast<int>(bits >> 23) - 127;
    Scaled scaled;
    scaled.scale = 8 - ((binary * 1233) >> 12);  // at most one too many: 1233 / 4096 is log10(2)
    scaled.number = static_cast<double>(value) * kPowers[static_cast<std::size_t>(scaled.scale)];
    if (scaled.number >= 1e9) {
        --scaled.scale;
        scaled.number = static_cast<double>(value) * kPowers[static_cast<std::size_t>(scaled.scale)];
    }
    scaled.half = kPowers[static_cast<std::size_t>(scaled.scale)] *
                  std::bit_cast<double>(static_cast<std::uint64_t>(binary - 24 + 1023) << 52);
    const std::uint32_t eight = nearest(scaled.number, 0.1);
    const std::uint32_t seven = nearest(scaled.number, 0.01);
    const double fromEight = scaled.awayFrom(eight, 10.0);
    const double fromSeven = scaled.awayFrom(seven, 100.0);
    const bool isSeven = fromSeven < scaled.half;
    if (fromEight >= scaled.half || Scaled::isUnsure(fromEight, scaled.half) ||
        Scaled::isUnsure(fromEight, 5.0) || Scaled::isUnsure(fromSeven, scaled.half) ||
        Scaled::isUnsure(fromSeven, 50.0)) {
        return false;
    }
    decimal = {isSeven ? 10 * seven : eight, isSeven ? 7 : 8, 9 - scaled.scale};
    if (isSeven && scaled.awayFrom(nearest(scaled.number, 0.001), 1000.0) < scaled.half + 1e-4 &&
        !shorten(scaled, decimal)) {
        return false;
    }
    if (decimal.digits >= 100'000'000) {  // it was rounded up to the next power of ten
        decimal.digits /= 10;
        ++decimal.exponent;
    }
    return true;
}

}  // namespace

char* writeFloat(char* to, float value) {
    const float size = std::abs(value);
    Decimal decimal;
    if (!(size >= 1e-4f && size < 1e7f) || !shortest(size, decimal)) {
        return writeSlowly(to, value);
    }
    char* at = to;
    *at = '-';
    at += value < 0.0f ? 1 : 0;  // not by a branch, which nothing foretells
    const std::uint64_t digits = eightDigits(decimal.digits);
    if (decimal.exponent <= 0) {  // 0.00ddd
        if (decimal.exponent == -3 && decimal.count == 1) {
            return writeSlowly(to, value);  // 1e-04 is shorter
        }
        std::memcpy(at, "0.000000", 8);
        at += 2 - decimal.exponent;
        storeDigits(at, digits);
        return at + decimal.count;
    }
    const auto whole = static_cast<std::size_t>(decimal.exponent);
    storeDigits(at, digits);
    if (decimal.count > decimal.exponent) {
        at[whole] = '.';
        storeDigits(at + whole + 1, digits >> 8 * whole);
        return at + decimal.count + 1;
    }
    // An exponent is shorter behind many zeros: 1e+05.
    constexpr int kExponent = 4;
    const int point = decimal.count > 1 ? 1 : 0;
    return decimal.exponent > decimal.count + point + kExponent ? writeSlowly(to, value) : at + whole;
}

char* writeSixDecimals(char* to, float value) {
    constexpr int kDecimals = 6;
    const double millionths = std::abs(static_cast<double>(value)) * 1e6 + 0.5;
    if (!(millionths < 1e7)) {
        return writeFloat(to, value);
    }
    const auto number = static_cast<std::uint32_t>(millionths);
    *to = '-';
    to += value < 0.0f && number != 0 ? 1 : 0;
    const std::uint64_t digits = eightDigits(number);  // a zero, one digit, the decimals
    const int zeros = std::min(std::countl_zero(digits) / 8, kDecimals);
    storeDigits(to, digits);
    to[0] = to[1];
    to[1] = '.';
    return zeros == kDecimals ? to + 1 : to + kLongest - zeros;
}

}  // namespace hitscope
