// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/navigation_preset.h"

#include <array>

namespace hitscope {

namespace {

constexpr std::array<DragBinding, 4> kHitscope{{{Qt::LeftButton, Qt::NoModifier, CameraMotion::Orbit},
                                                {Qt::LeftButton, Qt::ShiftModifier, CameraMotion::Pan},
                                                {Qt::RightButton, Qt::NoModifier, CameraMotion::Pan},
                                                {Qt::MiddleButton, Qt::NoModifier, CameraMotion::Pan}}};

constexpr std::array<DragBinding, 3> kBlender{{{Qt::MiddleButton, Qt::NoModifier, CameraMotion::Orbit},
                                               {Qt::MiddleButton, Qt::ShiftModifier, CameraMotion::Pan},
                                               {Qt::MiddleButton, Qt::ControlModifier, CameraMotion::Zoom}}};

}  // namespace

std::span<const DragBinding> dragBindings(NavigationPreset preset) {
    return preset == NavigationPreset::Blender ? std::span<const DragBinding>(kBlender) : kHitscope;
}

CameraMotion motionOf(NavigationPreset preset, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
    CameraMotion found = CameraMotion::None;
    for (const DragBinding& binding : dragBindings(preset)) {
        if (binding.button != button) {
            continue;
        }
        if (binding.key != Qt::NoModifier && keys.testFlag(binding.key)) {
            return binding.motion;
        }
        if (binding.key == Qt::NoModifier) {
            found = binding.motion;
        }
    }
    return found;
}

}  // namespace hitscope
