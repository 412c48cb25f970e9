// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "view/camera.h"

namespace hitscope {

/// The camera on its way from one place to another: eases in and out, turns the shorter way.
class CameraGlide {
public:
    static constexpr double kSeconds = 0.25;  ///< that a glide takes

    void start(const Camera& from, const Camera& to);
    void stop() { m_running = false; }
    [[nodiscard]] bool isRunning() const { return m_running; }
    /// Where it is going, exactly.
    [[nodiscard]] const Camera& goal() const { return m_to; }
    /// Where the camera is, `seconds` after the last call; the goal itself at the end, where it stops.
    [[nodiscard]] Camera advance(double seconds);

private:
    Camera m_from;
    Camera m_to;
    double m_passed = 0.0;  ///< seconds
    bool m_running = false;
};

/// Between two cameras, `part` in (0, 1); the projection and the scene's size are `to`'s.
[[nodiscard]] Camera between(const Camera& from, const Camera& to, float part);

}  // namespace hitscope
