// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hitscope {

/// What made a group of hits.
enum class HitGroupKind : std::uint8_t {
    None,
    Chosen,  ///< a person put them together
    Mirror,
    Scatter,
    Stroke,  ///< of the brush
};
/// As files and the interface name them, by HitGroupKind; empty for none.
inline constexpr std::array<std::string_view, 5> kHitGroupWords{"", "group", "mirror", "scatter", "stroke"};

/// Which hits were made together, so that they can be selected and changed as one. It deforms nothing. Hits
/// of one group need not stand side by side in the history, nor be on one target.
struct HitGroup {
    std::uint32_t number = 0;  ///< from 1, its own in a session among those of its kind; 0: of no group
    HitGroupKind kind = HitGroupKind::None;

    [[nodiscard]] explicit operator bool() const { return number != 0 && kind != HitGroupKind::None; }
    bool operator==(const HitGroup&) const = default;
};

/// "scatter 3"; empty for none.
[[nodiscard]] std::string groupText(const HitGroup& group);
/// The group of that text; nothing: it is none of a group.
[[nodiscard]] std::optional<HitGroup> groupOf(std::string_view text);

}  // namespace hitscope
