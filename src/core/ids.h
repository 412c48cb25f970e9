// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace hitscope {

/// Names a target for as long as the session lives; never reused. 0 names none.
struct TargetId {
    std::uint32_t value = 0;
    auto operator<=>(const TargetId&) const = default;
    explicit operator bool() const { return value != 0; }
};

/// Names a projectile for as long as the physics world lives; never reused. 0 names none.
struct ProjectileId {
    std::uint32_t value = 0;
    auto operator<=>(const ProjectileId&) const = default;
    explicit operator bool() const { return value != 0; }
};

}  // namespace hitscope

template <>
struct std::hash<hitscope::TargetId> {
    std::size_t operator()(hitscope::TargetId id) const noexcept { return id.value; }
};
template <>
struct std::hash<hitscope::ProjectileId> {
    std::size_t operator()(hitscope::ProjectileId id) const noexcept { return id.value; }
};
