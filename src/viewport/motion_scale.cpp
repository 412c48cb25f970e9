// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/motion_scale.h"

#include <array>
#include <utility>

namespace hitscope {

namespace {

constexpr std::array kScales{1.0f, 0.70710678f, 0.5f};  // each has half of the pixels of the one before
constexpr int kJudged = 3;                              // frames that are judged together
// A level less has twice the pixels, and its frames take at most twice as long; a little less than half keeps
// sizes from going up and down.
constexpr double kFastEnough = 0.4 * MotionScale::kLongestFrame;  // seconds
constexpr double kGain = 0.9;  // of the time before: half of the pixels that save less are not worth it

}  // namespace

float MotionScale::scale() const {
    return kScales[m_level];
}

void MotionScale::setLevel(std::size_t level) {
    m_level = level;
    m_isSettling = true;
}

void MotionScale::forget() {
    *this = MotionScale();
}

void MotionScale::frameTook(double seconds) {
    if (std::exchange(m_isSettling, false)) {
        return;
    }
    m_sum += seconds;
    if (++m_frames == kJudged) {
        judge(std::exchange(m_sum, 0.0) / std::exchange(m_frames, 0));
    }
}

void MotionScale::judge(double mean) {
    if (const double before = std::exchange(m_before, 0.0); before > 0.0 && mean > kGain * before) {
        m_isNoHelp = true;
        setLevel(m_level - 1);
    } else if (mean > kLongestFrame && m_level + 1 < kScales.size() && !m_isNoHelp) {
        m_before = mean;
        setLevel(m_level + 1);
    } else if (mean < kFastEnough && m_level > 0) {
        setLevel(m_level - 1);
    }
}

}  // namespace hitscope
