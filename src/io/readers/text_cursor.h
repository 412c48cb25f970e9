// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace hitscope {

/// For a file that ends too early.
inline constexpr const char* kCutAdvice = "Save or download it again: it is not whole.";

/// A word of a file in quotation marks, for messages; long ones are cut.
inline std::string quoted(std::string_view word) {
    constexpr std::size_t kLongest = 60;
    std::string text(1, '"');
    text += word.substr(0, kLongest);
    text += '"';
    return text;
}

/// Reads words and numbers from a piece of text that is not terminated by a zero. Numbers are rounded
/// correctly: what the file says is what comes out, to the last bit.
class TextCursor {
public:
    explicit TextCursor(std::string_view text)
        : m_at(text.data()), m_begin(text.data()), m_end(text.data() + text.size()) {}

    /// Past blanks and tabs, and with `lines` past line ends too.
    void skipBlanks(bool lines = false) {
        while (m_at != m_end && (isBlank(*m_at) || (lines && *m_at == '\n'))) {
            ++m_at;
        }
    }
    [[nodiscard]] bool atEnd() const { return m_at == m_end; }
    [[nodiscard]] char peek() const { return m_at == m_end ? '\0' : *m_at; }
    bool take(char c) {
        const bool there = peek() == c && !atEnd();
        m_at += there ? 1 : 0;
        return there;
    }
    [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(m_at - m_begin); }
    /// From an earlier offset() to the cursor.
    [[nodiscard]] std::string_view since(std::size_t start) const {
        return {m_begin + start, offset() - start};
    }
    [[nodiscard]] std::string_view rest() const { return {m_at, static_cast<std::size_t>(m_end - m_at)}; }

    /// The text up to the next blank or line end; empty at the end.
    std::string_view word(bool acrossLines = false) {
        skipBlanks(acrossLines);
        const char* const start = m_at;
        while (m_at != m_end && !isBlank(*m_at) && *m_at != '\n') {
            ++m_at;
        }
        return {start, static_cast<std::size_t>(m_at - start)};
    }
    std::string_view line() {
        const char* const start = m_at;
        const void* const found = m_at == m_end ? nullptr : std::memchr(m_at, '\n', rest().size());
        const char* const stop = found ? static_cast<const char*>(found) : m_end;
        m_at = found ? stop + 1 : m_end;
        return {start, static_cast<std::size_t>(stop - start)};
    }
    /// A number at the cursor, not followed by anything but a blank or the end; nothing (and the cursor where
    /// it was) if there is none. "inf" and "nan" are numbers here: the caller says what they mean.
    std::optional<double> number() {
        const char* const start = m_at;
        double value = 0.0;
        if (parse(value) && (m_at == m_end || isBlank(*m_at) || *m_at == '\n')) {
            return value;
        }
        m_at = start;
        return std::nullopt;
    }
    /// A whole number at the cursor, whatever follows it.
    std::optional<long long> integer() {
        const char* const start = m_at;
        long long value = 0;
        if (parse(value)) {
            return value;
        }
        m_at = start;
        return std::nullopt;
    }

    [[nodiscard]] static bool isBlank(char c) {
        return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
    }

private:
    template <class Number>
    bool parse(Number& value) {
        const char* from = m_at;
        if (from != m_end && *from == '+' && from + 1 != m_end && from[1] != '-') {
            ++from;
        }
        const auto [stop, error] = std::from_chars(from, m_end, value);
        if (error == std::errc::invalid_argument) {
            return false;
        }
        if (error == std::errc::result_out_of_range) {
            value = beyondRange(value, {from, static_cast<std::size_t>(stop - from)});
        }
        m_at = stop;
        return true;
    }
    /// Too small becomes zero, too large infinite: whatever the exponent says, zeros may make up for it.
    static double beyondRange(double, std::string_view digits) {
        const bool isNegative = digits.front() == '-';
        digits.remove_prefix(isNegative ? 1 : 0);
        const std::string_view mantissa = digits.substr(0, digits.find_first_of("eE"));
        const auto point = static_cast<long long>(std::min(mantissa.find('.'), mantissa.size()));
        const auto first =
            static_cast<long long>(std::min(mantissa.find_first_not_of("0."), mantissa.size()));
        long long exponent = 0;
        if (mantissa.size() < digits.size()) {
            TextCursor written(digits.substr(mantissa.size() + 1));
            exponent = std::clamp(written.integer().value_or(0), -kMostPlaces, kMostPlaces);
        }
        // The power of ten of the first digit that counts.
        const long long place = (first < point ? point - 1 : point) - first + exponent;
        const double magnitude = place < 0 ? 0.0 : HUGE_VAL;
        return isNegative ? -magnitude : magnitude;
    }
    static long long beyondRange(long long, std::string_view digits) {
        return digits.front() == '-' ? LLONG_MIN : LLONG_MAX;
    }

    static constexpr long long kMostPlaces = 1LL << 60;  ///< more than a file has digits

    const char* m_at;
    const char* m_begin;
    const char* m_end;
};

}  // namespace hitscope
