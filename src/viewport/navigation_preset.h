// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtCore/qnamespace.h>
#include <cstdint>
#include <span>

namespace hitscope {

/// What a drag does to the camera.
enum class CameraMotion : std::uint8_t { None, Orbit, Pan, Zoom };

/// Whose habits mouse and trackpad follow.
enum class NavigationPreset : std::uint8_t {
    Hitscope,  ///< left orbits, right and middle pan
    Blender,   ///< middle orbits; Shift: pans; Ctrl: zooms
};
inline constexpr int kNavigationPresets = 2;

struct DragBinding {
    Qt::MouseButton button;
    Qt::KeyboardModifier key;  ///< Qt::NoModifier, or one of Shift, Ctrl, Alt
    CameraMotion motion;
};

[[nodiscard]] std::span<const DragBinding> dragBindings(NavigationPreset preset);

/// What dragging with `button` does while `keys` are held. A key that the table does not name changes
/// nothing: it belongs to someone else.
[[nodiscard]] CameraMotion motionOf(NavigationPreset preset, Qt::MouseButton button,
                                    Qt::KeyboardModifiers keys);

}  // namespace hitscope
