// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "physics/projectile_settings.h"

namespace hitscope {

/// Simulated time: how long a step of the physics is, how many are due, and how fast time goes.
class StepClock {
public:
    static constexpr double kStep = 1.0 / 240.0;   ///< seconds; the default
    static constexpr double kLongestFrame = 0.25;  ///< seconds of simulated time

    /// `finishStep` is called before the time or the length of a step changes.
    explicit StepClock(std::function<void()> finishStep) : m_finishStep(std::move(finishStep)) {}

    /// Seconds simulated so far.
    [[nodiscard]] double time() const { return m_timeBefore + static_cast<double>(m_steps) * m_step; }
    void setTime(double seconds);  ///< while there are no projectiles; not finite: ignored
    [[nodiscard]] double step() const { return m_step; }
    void setStep(double seconds);  ///< clamped to stepParameter(); not finite: ignored
    [[nodiscard]] double timeScale() const { return m_timeScale; }
    void setTimeScale(double scale);  ///< clamped to timeScaleParameter(); not finite: ignored
    [[nodiscard]] bool isPaused() const { return m_isPaused; }
    void setPaused(bool paused) { m_isPaused = paused; }

    /// How many steps it is time for after `seconds` more, times the time scale. A remainder waits for the
    /// next call. At most kLongestFrame a call: the rest of the time is dropped, so that a slow frame cannot
    /// snowball. Paused: none.
    [[nodiscard]] int stepsDue(double seconds);
    /// A step was taken.
    void count() { ++m_steps; }
    /// Steps counted since setTime() or setStep().
    [[nodiscard]] std::int64_t steps() const { return m_steps; }
    /// How far drawing is between the last two steps, [0, 1).
    [[nodiscard]] float between() const { return static_cast<float>(m_waiting / m_step); }
    /// What is drawn until time goes on is the last step, not a place before it.
    void showLastStep();

private:
    std::function<void()> m_finishStep;
    double m_step = kStep;
    double m_timeBefore = 0.0;  ///< simulated before the step's length was last set
    std::int64_t m_steps = 0;   ///< since then
    double m_waiting = 0.0;     ///< seconds not simulated yet, < m_step
    double m_timeScale = timeScaleParameter().defaultValue;
    bool m_isPaused = false;
};

}  // namespace hitscope
