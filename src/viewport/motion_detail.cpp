// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/motion_detail.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hitscope {

namespace {

constexpr std::array kScales{1.0f, 0.70710678f, 0.5f};  // each has half of the pixels of the one before
constexpr int kJudged = 3;                              // frames that are judged together
// A level less has twice the pixels, and its frames take at most twice as long; a little less than half keeps
// sizes from going up and down. With all triangles they take longer in that proportion, at most.
constexpr double kFastEnough = 0.4;        // of the longest time: for twice the pixels
constexpr double kFastEnoughForAll = 0.8;  // for as many triangles
constexpr double kGain = 0.9;              // of the time before: what saves less is not worth it
constexpr double kTwoLevels = 2.0;         // times the longest: half of the pixels will not do
// Times the longest: no frame is worth waiting for another of these, where fewer triangles may help.
constexpr double kFarTooLong = 3.0;

}  // namespace

PictureDetail MotionDetail::detail() const {
    return {.scale = kScales[m_level], .coarse = m_coarse};
}

void MotionDetail::settle() {
    m_isSettling = true;
    m_sum = 0.0;
    m_frames = 0;
}

void MotionDetail::forget() {
    MotionDetail fresh;
    fresh.m_longest = m_longest;
    fresh.m_coarsePart = m_coarsePart;
    *this = fresh;
}

void MotionDetail::setLongestFrame(double seconds) {
    m_longest = seconds;
    forget();
}

void MotionDetail::tryAgain() {
    m_areFewTrianglesNoHelp = false;
    m_areFewPixelsNoHelp = false;
    m_waited = 0;
}

void MotionDetail::takeCoarse() {
    if (hasCoarse() && !m_coarse) {
        m_coarse = true;
        m_before = 0.0;
        m_sum = 0.0;
        m_frames = 0;
    }
}

void MotionDetail::setCoarsePart(float part) {
    m_coarsePart = part;
    forget();
}

void MotionDetail::frameTook(double seconds) {
    if (std::exchange(m_isSettling, false)) {
        return;
    }
    m_sum += seconds;
    ++m_frames;
    const bool isHopeless =
        seconds > kFarTooLong * m_longest && hasCoarse() && !m_coarse && !m_areFewTrianglesNoHelp;
    if (m_frames == kJudged || isHopeless) {
        judge(std::exchange(m_sum, 0.0) / std::exchange(m_frames, 0));
    }
}

void MotionDetail::judge(double mean) {
    if (const double before = std::exchange(m_before, 0.0); before > 0.0 && mean > kGain * before) {
        goBack();
    } else if (mean > m_longest) {
        drawLess(mean);
    } else {
        drawMore(mean);
    }
}

void MotionDetail::goBack() {
    if (m_level > m_levelBefore) {
        m_areFewPixelsNoHelp = true;
        m_level = m_levelBefore;
    } else {
        m_areFewTrianglesNoHelp = true;
        m_coarse = false;
    }
    settle();
}

void MotionDetail::drawLess(double mean) {
    m_levelBefore = m_level;
    if (m_level == 0 && !m_coarse && hasCoarse() && !m_areFewTrianglesNoHelp) {
        m_coarse = true;
    } else if (m_level + 1 < kScales.size() && !m_areFewPixelsNoHelp) {
        m_level = std::min(m_level + (mean > kTwoLevels * m_longest ? 2 : 1), kScales.size() - 1);
    } else {
        wait();
        return;
    }
    m_before = mean;
    settle();
}

/// Something else may have taken the time when steps were no help.
void MotionDetail::wait() {
    if (++m_waited == m_patience) {
        tryAgain();
        m_patience *= 2;
    }
}

void MotionDetail::drawMore(double mean) {
    if (m_level > 0 && mean < kFastEnough * m_longest) {
        --m_level;
        settle();
    } else if (m_level == 0 && m_coarse &&
               mean < kFastEnoughForAll * m_longest * static_cast<double>(m_coarsePart)) {
        m_coarse = false;
        settle();
    }
}

}  // namespace hitscope
