// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtCore/qnamespace.h>
#include <cstdint>
#include <span>

namespace hitscope {

/// What a drag, or two fingers on a trackpad, do to the camera.
enum class CameraMotion : std::uint8_t { None, Orbit, Pan, Zoom };

/// What orbiting turns about.
enum class OrbitMode : std::uint8_t {
    Point,      ///< the target's point under the cursor when the drag began; else the target in the picture
    Turntable,  ///< the camera's pivot
    Fly,        ///< the eye: it looks around
};
inline constexpr int kOrbitModes = 3;

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

/// What two fingers moving on a trackpad do.
[[nodiscard]] CameraMotion trackpadMotion(Qt::KeyboardModifiers keys);

}  // namespace hitscope
