// SPDX-License-Identifier: GPL-3.0-or-later
// When the viewport draws frames, and what goes on between them.
#include <algorithm>

#include "gl/swap_interval.h"
#include "session/paced_advance.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr double kLongestStep = 0.25;  // seconds: a window that stood still does not make the scene jump
constexpr double kSecond = 1.0e9;      // nanoseconds

}  // namespace

bool Viewport::wantsFrames() const {
    return isVisible() && (m_continuous || m_navigation.isMoving() || m_session.simulation().isMoving() ||
                           (m_scene && (m_scene->isReadBackPending() || m_scene->isFarBehind())));
}

/// Right after a frame, while the window it was shown in is still what GL draws into.
void Viewport::followRefresh() {
    if (!m_surface.keepsPictures() && m_unlimited != m_continuous) {
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
    return isVisible() && m_error.empty() &&
           (m_session.simulation().isCatchingUp() ||
            (m_scene && m_isSoftware && (m_scene->isBehind() || m_scene->isFarBehind())));
}

/// What takes longer than a picture is done in a turn of the event loop before it.
void Viewport::followPicture() {
    if (m_scene && m_isSoftware && isVisible() && m_error.empty() && m_scene->isFarBehind()) {
        m_catchUp.sliceLater();
    } else if (isCatchingUp() || m_catchUp.isSliceComing()) {
        m_catchUp.wantPicture();
    } else {
        wantPicture();
    }
}

void Viewport::slice() {
    const bool isBehind = isCatchingUp();
    if (m_scene && m_isSoftware && (m_scene->isBehind() || m_scene->isFarBehind())) {
        m_surface.makeCurrent();
        if (const Status applied = m_scene->applyMore(); !applied) {
            report(applied.error());
        }
        m_surface.doneCurrent();
    }
    if (isBehind) {
        m_catchUp.wantPicture();
    }
    moveOn();
}

void Viewport::moveOn() {
    if (!wantsFrames()) {
        m_costsTimer.start();
        m_clock.invalidate();
        m_sinceFrame.invalidate();  // a pause begins, whatever draws the next frame
        m_catchUp.end();
        m_motion.setCatchingUp(false);
        if (m_catchUp.isPictureWanted()) {
            wantPicture();
        }
        return;
    }
    const bool wasMoving = m_clock.isValid();
    const double passed =
        wasMoving ? std::min(static_cast<double>(m_clock.nsecsElapsed()) / kSecond, kLongestStep) : 0.0;
    m_clock.start();
    const bool isMoving = m_navigation.isMoving();
    if (isMoving || isCatchingUp() || m_session.simulation().isMoving()) {
        m_motion.moved();
    }
    if (m_session.simulation().isMoving()) {
        advanceWithin(m_session, passed);
    }
    m_navigation.advance(passed);
    // Many shots are fired, steps with many projectiles made, many hits applied and read back in slices.
    if (isCatchingUp() && !m_catchUp.isPictureDue(isMoving)) {
        m_catchUp.sliceLater();
        return;
    }
    m_frameFollows = wasMoving;  // the time since the last frame is no frame's where nothing moved
    m_motion.setCatchingUp(isCatchingUp());
    wantPicture();
}

PictureAhead::Hooks Viewport::aheadHooks() {
    return {.prepare = [this] { return prepareAhead(); },
            .begin = [this] { return drawAhead(); },
            .isFinished =
                [this] {
                    bool isDrawn = true;  // where the scene is gone, nothing comes of waiting
                    static_cast<void>(withScene([&isDrawn](SceneGpu& scene) -> Status {
                        isDrawn = scene.isDrawnAhead();
                        return Done{};
                    }));
                    return isDrawn;
                },
            .show = [this] { return showAhead(); },
            .paint = [this] { m_surface.widget().update(); }};
}

bool Viewport::prepareAhead() {
    QElapsedTimer clock;
    clock.start();
    bool isPrepared = true;  // where it fails, drawing does too, and says so
    static_cast<void>(withScene([&](SceneGpu& scene) -> Status {
        SceneGpu::View coming = view();
        coming.detail = m_motion.coming();
        const Result<bool> prepared = scene.prepare(coming, m_refiner.view());
        isPrepared = !prepared || prepared.value();
        return Done{};
    }));
    m_preparing += static_cast<double>(clock.nsecsElapsed()) / kSecond;
    return isPrepared;
}

bool Viewport::drawAhead() {
    bool isBegun = false;
    const Status drawn = withScene([&](SceneGpu& scene) -> Status {
        const Result<bool> begun = scene.drawAhead(beginPicture(), m_refiner.view());
        if (!begun) {
            return begun.error();
        }
        isBegun = begun.value();
        return Done{};
    });
    if (!drawn) {
        m_kept = QImage();  // painting finds the same, and reports it
        return false;
    }
    if (isBegun) {
        pictureBegun();
    } else {
        m_kept = QImage();
    }
    return isBegun;
}

bool Viewport::showAhead() {
    static_cast<void>(withScene([this](SceneGpu& scene) -> Status {
        readKept(scene);
        return Done{};
    }));
    return m_surface.showNow();
}

void Viewport::collectCosts() {
    if (m_scene) {
        m_surface.makeCurrent();
        m_scene->collectCosts();
        m_surface.doneCurrent();
    }
}

/// What the renderer has not been tried with yet, while nothing moves.
void Viewport::tryNext() {
    if (m_scene && !wantsFrames()) {
        m_surface.makeCurrent();
        const bool isMore = m_scene->tryNext();
        m_surface.doneCurrent();
        if (!isMore) {
            m_trialTimer.stop();
        }
    }
}

}  // namespace hitscope
