// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/dent_form_text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace hitscope {

namespace {

template <class Enum, class Keys>
std::optional<Enum> named(const Keys& keys, std::string_view key) {
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? std::nullopt : std::optional(static_cast<Enum>(found - keys.begin()));
}

}  // namespace

std::optional<DentProfile> profileNamed(std::string_view key) {
    return named<DentProfile>(kDentProfileKeys, key);
}

std::optional<DentDirection> directionNamed(std::string_view key) {
    return named<DentDirection>(kDentDirectionKeys, key);
}

std::string_view keyOf(DentProfile profile) {
    return kDentProfileKeys[static_cast<std::size_t>(profile)];
}

std::string_view keyOf(DentDirection direction) {
    return kDentDirectionKeys[static_cast<std::size_t>(direction)];
}

std::string curveText(const CurveOrdinates& curve, char separator) {
    std::string text;
    for (const float ordinate : curve) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), ordinate).ptr;
        if (!text.empty()) {
            text += separator;
        }
        text.append(digits.data(), end);
    }
    return text;
}

std::optional<CurveOrdinates> curveFrom(std::string_view text, char separator) {
    CurveOrdinates curve{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (i > 0 && (at == end || *at++ != separator)) {
            return std::nullopt;
        }
        const auto [after, error] = std::from_chars(at, end, curve[i]);
        if (error != std::errc() || !(curve[i] >= -1.0f && curve[i] <= 1.0f)) {
            return std::nullopt;
        }
        at = after;
    }
    return at == end ? std::optional(curve) : std::nullopt;
}

}  // namespace hitscope
