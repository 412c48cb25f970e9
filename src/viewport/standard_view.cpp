// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/standard_view.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace hitscope {

namespace {

constexpr float kSame = 1.0e-4f;  // radians

struct Angles {
    float yaw;
    float pitch;
};

Angles anglesOf(StandardView view) {
    constexpr float kQuarter = glm::half_pi<float>();
    switch (view) {
        case StandardView::Front:
            return {0.0f, 0.0f};
        case StandardView::Back:
            return {glm::pi<float>(), 0.0f};
        case StandardView::Right:
            return {kQuarter, 0.0f};
        case StandardView::Left:
            return {-kQuarter, 0.0f};
        case StandardView::Top:
            return {0.0f, kQuarter};
        case StandardView::Bottom:
            break;
    }
    return {0.0f, -kQuarter};
}

}  // namespace

Camera turnedTo(StandardView view, const Camera& camera, const glm::vec3& about) {
    const Angles angles = anglesOf(view);
    Camera turned = camera;
    turned.orbitAbout(about, angles.yaw - camera.yaw(), angles.pitch - camera.pitch());
    return turned;
}

std::optional<StandardView> standardViewOf(const Camera& camera) {
    for (const StandardView view : kStandardViews) {
        const Angles angles = anglesOf(view);
        if (std::abs(std::remainder(camera.yaw() - angles.yaw, glm::two_pi<float>())) < kSame &&
            std::abs(camera.pitch() - angles.pitch) < kSame) {
            return view;
        }
    }
    return std::nullopt;
}

}  // namespace hitscope
