// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/picture_motion.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

constexpr float kHurriedScale = 0.70710678f;  // half of the pixels
constexpr double kFar = 1.5;                  // times too slow: one such frame is enough

}  // namespace

PictureMotion::PictureMotion(QObject* parent) : QObject(parent) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(kRest);
    connect(&m_timer, &QTimer::timeout, this, &PictureMotion::rest);
}

void PictureMotion::setOn(bool on) {
    m_isOn = on;
    drawInFullIfAtRest();
}

void PictureMotion::setRefined(bool on) {
    m_isRefined = on;
    drawInFullIfAtRest();
}

void PictureMotion::setBusy(bool on) {
    m_isBusy = on;
    drawInFullIfAtRest();
}

void PictureMotion::moved() {
    m_timer.start();
}

void PictureMotion::setCoarsePart(float part, bool isSlow) {
    m_motion.setCoarsePart(part);
    m_isSlowFirst = isSlow && m_motion.hasCoarse();
    forget();
}

void PictureMotion::forget() {
    m_motion.forget();
    m_isSlow = m_isSlowFirst;
    m_fullFrames = 0;
    m_slowFrames = 0;
    drawInFullIfAtRest();
}

void PictureMotion::seenFrom(float distance) {
    constexpr float kOther = 2.0f;  // times as far or as near
    if (distance > kOther * m_distance || distance * kOther < m_distance) {
        m_distance = distance;
        m_motion.tryAgain();
    }
}

/// The refiner may have been going to draw the picture that now nobody else draws.
void PictureMotion::drawInFullIfAtRest() {
    if (!m_timer.isActive() && isReduced()) {
        Q_EMIT rested();
    }
}

bool PictureMotion::isReduced() const {
    return m_detail.scale < 1.0f || (m_detail.coarse && !isLeftToRefiner());
}

bool PictureMotion::isFirstComing() const {
    return m_isFirst || !m_isOn || !m_timer.isActive();
}

PictureDetail PictureMotion::coming() const {
    PictureDetail detail = isFirstComing() ? PictureDetail() : m_held.value_or(m_motion.detail());
    if (isLeftToRefiner() && !m_held) {
        detail.coarse = true;
    }
    if (isHurried()) {
        detail.scale = std::min(detail.scale, kHurriedScale);
    }
    return detail;
}

PictureDetail PictureMotion::beginFrame() {
    if (isLeftToRefiner()) {
        m_motion.takeCoarse();
    }
    m_detail = coming();
    // A motion's first frame comes after a pause, and others may do as much meanwhile: its time is not
    // counted, and neither is that of one with a detail that the times did not choose.
    m_isCounted = !isFirstComing() && !isHurried() && !m_held;
    m_isFirst = false;
    m_isKeptShown = false;
    m_isDrawn = true;
    return m_detail;
}

void PictureMotion::frameShown(double seconds) {
    m_seen = {.scale = m_detail.scale, .coarse = m_detail.coarse && m_drewCoarse};
    judgeFull(seconds);
    m_isDrawn = false;
    if (!std::exchange(m_isRestDue, false) && !m_timer.isActive()) {
        drawInFullIfAtRest();
        return;
    }
    if (std::exchange(m_isCounted, false)) {
        m_motion.frameTook(seconds);
    }
    m_timer.start();  // what drawing took is no rest
}

/// Fewer triangles take at least their part of the time that all of them would take.
void PictureMotion::judgeFull(double seconds) {
    if (m_isKeptShown || !m_motion.hasCoarse()) {
        return;
    }
    const double part = m_detail.isFull() ? 1.0 : static_cast<double>(m_motion.coarsePart());
    const bool isSlow = seconds > part * m_slow || m_waiting > part * m_slowWaiting;
    if (m_detail.isFull()) {
        // The first one after a change may have built programs; one alone may have been held up.
        const bool isFarTooSlow = seconds > kFar * m_slow || m_waiting > kFar * m_slowWaiting;
        const bool isCounted = ++m_fullFrames > 1;
        m_slowFrames = isCounted && isSlow ? m_slowFrames + 1 : 0;
        m_isSlow = m_slowFrames > 1 || (isCounted && isFarTooSlow);
    } else if (m_detail.coarse && !isSlow) {
        m_isSlow = false;
    }
}

void PictureMotion::keptShown(bool isRough) {
    m_detail = PictureDetail{.coarse = isRough};
    m_drewCoarse = isRough;
    m_isKeptShown = true;
    m_isCounted = false;
}

void PictureMotion::rest() {
    if (m_isDrawn) {
        m_isRestDue = true;
        return;
    }
    m_isFirst = true;
    if (isReduced()) {
        Q_EMIT rested();
    }
}

}  // namespace hitscope
