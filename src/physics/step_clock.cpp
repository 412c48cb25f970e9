// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/step_clock.h"

#include <algorithm>
#include <cmath>

namespace hitscope {

void StepClock::setTime(double seconds) {
    if (std::isfinite(seconds)) {
        m_finishStep();
        m_timeBefore = seconds;
        m_steps = 0;
    }
}

void StepClock::setStep(double seconds) {
    const ParameterDescriptor& range = stepParameter();
    if (std::isfinite(seconds)) {
        m_finishStep();
        m_timeBefore = time();
        m_steps = 0;
        m_waiting = 0.0;
        m_step = std::clamp(seconds, range.minimum, range.maximum);
    }
}

void StepClock::setTimeScale(double scale) {
    const ParameterDescriptor& range = timeScaleParameter();
    if (std::isfinite(scale)) {
        m_timeScale = std::clamp(scale, range.minimum, range.maximum);
    }
}

int StepClock::stepsDue(double seconds) {
    if (m_isPaused || !(seconds > 0.0) || !std::isfinite(seconds)) {
        return 0;
    }
    m_waiting += seconds * m_timeScale;
    // A frame of exactly n steps must not lose one to rounding.
    const double due = std::floor(m_waiting / m_step + 1.0e-6);
    const double most = std::round(kLongestFrame / m_step);
    const int count = static_cast<int>(std::min(due, most));
    m_waiting = due > most ? 0.0 : std::max(0.0, m_waiting - count * m_step);
    return count;
}

void StepClock::showLastStep() {
    m_waiting = std::nextafter(m_step, 0.0);
}

}  // namespace hitscope
