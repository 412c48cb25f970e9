// SPDX-License-Identifier: GPL-3.0-or-later
// When the viewport draws frames, and what goes on between them.
#include <algorithm>

#include "gl/swap_interval.h"
#include "session/paced_advance.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr qint64 kCatchUpFrames = 500;  // milliseconds between frames while the session catches up
constexpr double kLongestStep = 0.25;   // seconds: a window that stood still does not make the scene jump
constexpr double kSecond = 1.0e9;       // nanoseconds

}  // namespace

bool Viewport::wantsFrames() const {
    return isVisible() && (m_continuous || m_navigation.isMoving() || m_session.simulation().isMoving() ||
                           (m_scene && m_scene->isReadBackPending()));
}

/// Right after a frame, while the window it was shown in is still what GL draws into.
void Viewport::followRefresh() {
    if (m_unlimited != m_continuous) {
        m_unlimited = m_continuous;
        gl::setSwapInterval(m_unlimited ? 0 : 1);
    }
}

void Viewport::startClock() {
    if (!m_clock.isValid() && m_session.simulation().isMoving()) {
        m_clock.start();
    }
}

/// Whether a frame for each slice of the work would take longer than the slices. What a GPU applies it
/// applies beside the frames, and falls behind without them.
bool Viewport::isCatchingUp() const {
    return m_session.simulation().isCatchingUp() || (m_scene && m_isSoftware && m_scene->isApplying());
}

void Viewport::updateUnlessCatchingUp() {
    if (!isCatchingUp()) {
        update();
    }
}

void Viewport::applyMore() {
    makeCurrent();
    if (const Status applied = m_scene->applyMore(); !applied) {
        report(applied.error());
    }
    doneCurrent();
}

void Viewport::moveOn() {
    if (!wantsFrames()) {
        m_costsTimer.start();
        m_clock.invalidate();
        return;
    }
    const double passed = m_clock.isValid()
                              ? std::min(static_cast<double>(m_clock.nsecsElapsed()) / kSecond, kLongestStep)
                              : 0.0;
    m_clock.start();
    if (m_navigation.isMoving() || m_session.simulation().isMoving()) {
        m_motion.moved();
    }
    if (m_session.simulation().isMoving()) {
        advanceWithin(m_session, passed);
    }
    m_navigation.advance(passed);
    // Many shots are fired, steps with many projectiles made and many hits applied in slices, between which
    // events are seen to.
    if (isCatchingUp() && m_sinceFrame.isValid() && m_sinceFrame.elapsed() < kCatchUpFrames) {
        if (m_scene && m_scene->isApplying()) {
            applyMore();
        }
        if (isCatchingUp()) {
            m_sliceTimer.start();
            return;
        }
    }
    m_frameFollows = true;
    update();
}

void Viewport::collectCosts() {
    if (m_scene) {
        makeCurrent();
        m_scene->collectCosts();
        doneCurrent();
    }
}

/// What the renderer has not been tried with yet, while nothing moves.
void Viewport::tryNext() {
    if (m_scene && !wantsFrames()) {
        makeCurrent();
        const bool isMore = m_scene->tryNext();
        doneCurrent();
        if (!isMore) {
            m_trialTimer.stop();
        }
    }
}

}  // namespace hitscope
