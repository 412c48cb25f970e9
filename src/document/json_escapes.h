// SPDX-License-Identifier: GPL-3.0-or-later
// Characters in the texts of JSON; for the files that read it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hitscope {

inline bool isJsonSpace(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

/// How many bytes the character of UTF-8 at the begin of `text` has; 0: it is none.
[[nodiscard]] std::size_t lengthOfUtf8(std::string_view text);
/// `code` is below 0x110000.
void appendUtf8(std::string& text, std::uint32_t code);

/// What "\uXXXX" at the begin of `text`, or a pair of them, stands for, and how long it is.
struct Escaped {
    std::uint32_t code = 0;
    std::size_t length = 0;
};
/// Nothing: they stand for no character.
[[nodiscard]] std::optional<Escaped> escapedAt(std::string_view text);

}  // namespace hitscope
