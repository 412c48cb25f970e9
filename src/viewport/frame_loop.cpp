// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/frame_loop.h"

#include <QWidget>
#include <algorithm>

#include "gl/swap_interval.h"
#include "session/paced_advance.h"
#include "viewport/navigation.h"
#include "viewport/picture_flow.h"
#include "viewport/surface/picture_surface.h"
#include "viewport/viewport_scene.h"

namespace hitscope {

namespace {

constexpr double kLongestStep = 0.25;  // seconds: a window that stood still does not make the scene jump
constexpr double kSecond = 1.0e9;      // nanoseconds
constexpr int kCostsArrive = 200;      // milliseconds after the last frame of many
constexpr int kTrialPause = 250;       // milliseconds between two things that are tried, each some ten long

}  // namespace

FrameLoop::FrameLoop(Parts parts, const QWidget& viewport) : m_parts(parts), m_viewport(viewport) {
    m_costsTimer.setSingleShot(true);
    m_costsTimer.setInterval(kCostsArrive);
    connect(&m_costsTimer, &QTimer::timeout, this, &FrameLoop::collectCosts);
    m_trialTimer.setInterval(kTrialPause);
    connect(&m_trialTimer, &QTimer::timeout, this, &FrameLoop::tryNext);
    connect(&m_catchUp, &CatchUp::sliceDue, this, &FrameLoop::slice);
    connect(&parts.session, &Session::pictureChanged, this, &FrameLoop::followPicture);
    connect(&parts.session, &Session::pictureChanged, this, &FrameLoop::startClock);
    connect(&parts.pictures, &PictureFlow::shown, &m_catchUp, &CatchUp::pictureShown);
    connect(&parts.scene, &ViewportScene::made, this, [this] {
        m_unlimited = false;  // another context, perhaps in another window
        if (m_parts.scene.exists()) {
            m_trialTimer.start();
        }
    });
    connect(&parts.scene, &ViewportScene::aboutToRelease, &m_trialTimer, &QTimer::stop);
}

bool FrameLoop::followsOn() const {
    const SceneGpu* const scene = m_parts.scene.get();
    return m_viewport.isVisible() &&
           (m_continuous || m_parts.navigation.isMoving() || m_parts.session.simulation().isMoving() ||
            (scene != nullptr && (scene->isReadBackPending() || scene->isFarBehind())));
}

void FrameLoop::windowPainted() {
    followRefresh();
    if (isCatchingUp()) {
        m_catchUp.sliceLater();
    } else {
        moveOn();
    }
}

/// Right after a frame, while the window it was shown in is still what GL draws into.
void FrameLoop::followRefresh() {
    if (!m_parts.surface.keepsPictures() && m_unlimited != m_continuous) {
        m_unlimited = m_continuous;
        gl::setSwapInterval(m_unlimited ? 0 : 1);
    }
}

void FrameLoop::startClock() {
    if (!m_clock.isValid() && m_parts.session.simulation().isMoving()) {
        m_clock.start();
    }
}

bool FrameLoop::isFarBehind() const {
    const SceneGpu* const scene = m_parts.scene.get();
    return scene != nullptr && m_parts.scene.isSoftware() && scene->isFarBehind();
}

bool FrameLoop::isApplying() const {
    const SceneGpu* const scene = m_parts.scene.get();
    return isFarBehind() || (scene != nullptr && m_parts.scene.isSoftware() && scene->isBehind());
}

/// Whether a frame for each slice of the work would take longer than the slices. What a GPU applies it
/// applies beside the frames, and falls behind without them.
bool FrameLoop::isCatchingUp() const {
    return m_viewport.isVisible() && m_parts.pictures.error().empty() &&
           (m_parts.session.simulation().isCatchingUp() || isApplying());
}

/// What takes longer than a picture is done in a turn of the event loop before it.
void FrameLoop::followPicture() {
    if (m_viewport.isVisible() && m_parts.pictures.error().empty() && isFarBehind()) {
        m_catchUp.sliceLater();
    } else if (isCatchingUp() || m_catchUp.isSliceComing()) {
        m_catchUp.wantPicture();
    } else {
        m_parts.pictures.want();
    }
}

void FrameLoop::slice() {
    const bool isBehind = isCatchingUp();
    if (isApplying()) {
        if (const Status applied = m_parts.scene.with([](SceneGpu& scene) { return scene.applyMore(); });
            !applied) {
            m_parts.pictures.report(applied.error());
        }
    }
    if (isBehind) {
        m_catchUp.wantPicture();
    }
    moveOn();
}

void FrameLoop::moveOn() {
    PictureFlow& pictures = m_parts.pictures;
    Navigation& navigation = m_parts.navigation;
    if (!followsOn()) {
        m_costsTimer.start();
        m_clock.invalidate();
        pictures.pause();
        m_catchUp.end();
        pictures.motion().setCatchingUp(false);
        if (m_catchUp.isPictureWanted()) {
            pictures.want();
        }
        return;
    }
    const bool wasMoving = m_clock.isValid();
    const double passed =
        wasMoving ? std::min(static_cast<double>(m_clock.nsecsElapsed()) / kSecond, kLongestStep) : 0.0;
    m_clock.start();
    const bool isMoving = navigation.isMoving();
    if (isMoving || isCatchingUp() || m_parts.session.simulation().isMoving()) {
        pictures.motion().moved();
    }
    if (m_parts.session.simulation().isMoving()) {
        advanceWithin(m_parts.session, passed);
    }
    navigation.advance(passed);
    // Many shots are fired, steps with many projectiles made, many hits applied and read back in slices.
    if (isCatchingUp() && !m_catchUp.isPictureDue(isMoving)) {
        m_catchUp.sliceLater();
        return;
    }
    pictures.setFollows(wasMoving);  // the time since the last frame is no frame's where nothing moved
    pictures.motion().setCatchingUp(isCatchingUp());
    pictures.want();
}

void FrameLoop::collectCosts() {
    static_cast<void>(m_parts.scene.with([](SceneGpu& scene) -> Status {
        scene.collectCosts();
        return Done{};
    }));
}

/// What the renderer has not been tried with yet, while nothing moves.
void FrameLoop::tryNext() {
    if (followsOn()) {
        return;
    }
    static_cast<void>(m_parts.scene.with([this](SceneGpu& scene) -> Status {
        if (!scene.tryNext()) {
            m_trialTimer.stop();
        }
        return Done{};
    }));
}

}  // namespace hitscope
