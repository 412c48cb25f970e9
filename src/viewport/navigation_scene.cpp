// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps the scene in the picture while a hand moves the camera.
#include <algorithm>
#include <array>
#include <cmath>

#include "viewport/navigation.h"

namespace hitscope {

namespace {

constexpr float kPartThatCounts = 0.9f;                           // of the picture: not its very edge
constexpr std::array<double, 5> kLooks{0.5, 0.3, 0.7, 0.1, 0.9};  // of the picture's width and height
constexpr int kStepHalvings = 6;

}  // namespace

bool Navigation::isSceneInSight() const {
    const SceneInSight now = scene();
    const auto isShown = [this](const Bounds& target) {
        const Bounds core = coreOf(target);
        // From within, its sides are in the picture and may be nothing to see.
        const Bounds around = m_camera.isOrthographic() ? Bounds() : core;
        const glm::vec3 eye = m_camera.eye();
        const bool isWithin =
            glm::all(glm::lessThanEqual(around.min, eye)) && glm::all(glm::lessThanEqual(eye, around.max));
        return !isWithin && isInPicture(core, m_camera, aspect(), kPartThatCounts);
    };
    if (now.targets.empty() || std::any_of(now.targets.begin(), now.targets.end(), isShown)) {
        return true;
    }
    // Near a part of a target its middle may be anywhere.
    return std::any_of(kLooks.begin(), kLooks.end(), [this](double y) {
        return std::any_of(kLooks.begin(), kLooks.end(), [this, y](double x) {
            return m_surfaceAt({x * m_size.width(), y * m_size.height()}).has_value();
        });
    });
}

glm::vec3 Navigation::anchorAt(const QPointF& position) const {
    if (const auto surface = m_surfaceAt(position)) {
        return *surface;
    }
    if (const auto centre = centreInSight(scene(), m_camera, aspect())) {
        return *centre;
    }
    return m_surfaceAt({0.5 * m_size.width(), 0.5 * m_size.height()}).value_or(m_camera.pivot());
}

glm::vec3 Navigation::zoomAnchorAt(const QPointF& position) const {
    if (const auto surface = m_surfaceAt(position)) {
        return *surface;
    }
    if (const auto middle = m_surfaceAt({0.5 * m_size.width(), 0.5 * m_size.height()})) {
        return *middle;
    }
    return centreInSight(scene(), m_camera, aspect()).value_or(m_camera.pivot());
}

void Navigation::turnBy(const QPointF& delta) {
    takeHold();
    m_anchor = centreInSight(scene(), m_camera, aspect());
    moveBy(CameraMotion::Orbit, delta);
    m_anchor.reset();
}

void Navigation::zoom(float factor, const glm::vec3& about) {
    const float from = m_camera.eye().y;
    const std::optional<float> floor = scene().floor;
    const bool staysAbove = floor && !m_camera.isOrthographic() && from >= *floor && about.y >= *floor;
    moveInSight([&](float part) {
        m_camera.zoomAbout(about, std::pow(factor, part));
        if (staysAbove && m_camera.eye().y < *floor) {
            m_camera = raisedAbove(*floor, m_camera, about);
        }
    });
}

void Navigation::moveInSight(const std::function<void(float part)>& move) {
    const Camera before = m_camera;
    const bool wasInSight = isSceneInSight();
    move(1.0f);
    if (!wasInSight || isSceneInSight()) {
        return;
    }
    float low = 0.0f;
    float high = 1.0f;
    for (int i = 0; i < kStepHalvings; ++i) {
        const float middle = 0.5f * (low + high);
        m_camera = before;
        move(middle);
        (isSceneInSight() ? low : high) = middle;
    }
    m_camera = before;
    if (low > 0.0f) {
        move(low);
    }
}

}  // namespace hitscope
