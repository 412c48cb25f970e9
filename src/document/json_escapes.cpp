// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/json_escapes.h"

#include <algorithm>
#include <charconv>

namespace hitscope {

namespace {

/// Four hexadecimal digits at the begin of `text`.
std::optional<std::uint32_t> hexOf(std::string_view text) {
    std::uint32_t code = 0;
    const char* const end = text.data() + std::min<std::size_t>(text.size(), 4);
    const auto [read, error] = std::from_chars(text.data(), end, code, 16);
    return error == std::errc() && read == text.data() + 4 ? std::optional(code) : std::nullopt;
}

}  // namespace

std::size_t lengthOfUtf8(std::string_view text) {
    const auto byte = [text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const auto follows = [&byte](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned first = byte(0);
    if (first < 0x80u) {
        return 1;
    }
    if (first >= 0xc2u && first <= 0xdfu) {
        return follows(1) ? 2 : 0;
    }
    if ((first & 0xf0u) == 0xe0u) {
        const unsigned code = (first & 0xfu) << 12 | (byte(1) & 0x3fu) << 6;
        const bool isSurrogate = code >= 0xd800u && code < 0xe000u;
        return follows(1) && follows(2) && code >= 0x800u && !isSurrogate ? 3 : 0;
    }
    if (first >= 0xf0u && first <= 0xf4u) {
        const unsigned code = (first & 0x7u) << 18 | (byte(1) & 0x3fu) << 12;
        return follows(1) && follows(2) && follows(3) && code >= 0x10000u && code < 0x110000u ? 4 : 0;
    }
    return 0;
}

void appendUtf8(std::string& text, std::uint32_t code) {
    const auto put = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80u) {
        put(code);
    } else if (code < 0x800u) {
        put(0xc0u | code >> 6);
        put(0x80u | (code & 0x3fu));
    } else if (code < 0x10000u) {
        put(0xe0u | code >> 12);
        put(0x80u | (code >> 6 & 0x3fu));
        put(0x80u | (code & 0x3fu));
    } else {
        put(0xf0u | code >> 18);
        put(0x80u | (code >> 12 & 0x3fu));
        put(0x80u | (code >> 6 & 0x3fu));
        put(0x80u | (code & 0x3fu));
    }
}

std::optional<Escaped> escapedAt(std::string_view text) {
    constexpr std::size_t kLength = 6;
    const std::optional<std::uint32_t> code = hexOf(text.substr(std::min<std::size_t>(text.size(), 2)));
    if (!code || (*code >= 0xdc00u && *code < 0xe000u)) {
        return std::nullopt;
    }
    if (*code < 0xd800u || *code >= 0xe000u) {
        return Escaped{*code, kLength};
    }
    if (text.substr(kLength, 2) != "\\u") {
        return std::nullopt;
    }
    const std::optional<std::uint32_t> low = hexOf(text.substr(kLength + 2));
    if (!low || *low < 0xdc00u || *low >= 0xe000u) {
        return std::nullopt;
    }
    return Escaped{0x10000u + ((*code - 0xd800u) << 10) + (*low - 0xdc00u), 2 * kLength};
}

}  // namespace hitscope
