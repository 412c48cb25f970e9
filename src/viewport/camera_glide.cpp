// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_glide.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

namespace hitscope {

void CameraGlide::start(const Camera& from, const Camera& to) {
    m_from = from;
    m_to = to;
    m_passed = 0.0;
    m_running = true;
}

Camera CameraGlide::advance(double seconds) {
    m_passed += seconds;
    if (m_passed >= kSeconds) {
        m_running = false;
        return m_to;
    }
    const auto part = static_cast<float>(m_passed / kSeconds);
    return between(m_from, m_to, part * part * (3.0f - 2.0f * part));
}

Camera between(const Camera& from, const Camera& to, float part) {
    const float turn = std::remainder(to.yaw() - from.yaw(), glm::two_pi<float>());
    Camera camera = to;
    camera.setFieldOfView(glm::mix(from.fieldOfView(), to.fieldOfView(), part));
    // Distances by ratio: coming near looks as fast as going away.
    camera.restore(glm::mix(from.pivot(), to.pivot(), part), from.yaw() + part * turn,
                   glm::mix(from.pitch(), to.pitch(), part),
                   from.distance() * std::pow(to.distance() / from.distance(), part));
    return camera;
}

}  // namespace hitscope
