// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/hit_group.h"

#include <charconv>

namespace hitscope {

std::string groupText(const HitGroup& group) {
    if (!group) {
        return {};
    }
    return std::string(kHitGroupWords[static_cast<std::size_t>(group.kind)]) + " " +
           std::to_string(group.number);
}

std::optional<HitGroup> groupOf(std::string_view text) {
    const std::size_t space = text.find(' ');
    if (space == std::string_view::npos || space == 0) {
        return std::nullopt;
    }
    const std::string_view word = text.substr(0, space);
    const std::string_view digits = text.substr(space + 1);
    for (std::size_t kind = 1; kind < kHitGroupWords.size(); ++kind) {
        if (word == kHitGroupWords[kind]) {
            HitGroup group{0, static_cast<HitGroupKind>(kind)};
            const auto [end, error] =
                std::from_chars(digits.data(), digits.data() + digits.size(), group.number);
            const bool isWhole = error == std::errc() && end == digits.data() + digits.size();
            return isWhole && group ? std::optional(group) : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace hitscope
