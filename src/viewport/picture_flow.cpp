// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/picture_flow.h"

#include <QWidget>
#include <algorithm>
#include <utility>

#include "scene/picture.h"
#include "scene/refined_view.h"
#include "session/frame_costs.h"
#include "viewport/surface/picture_surface.h"
#include "viewport/viewport_scene.h"

namespace hitscope {

namespace {

constexpr double kNanosecond = 1.0e-9;  // seconds

double secondsOf(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * kNanosecond;
}

}  // namespace

PictureFlow::PictureFlow(ViewportScene& scene, PictureSurface& surface, FrameCosts& costs, Hooks hooks)
    : m_scene(scene), m_surface(surface), m_costs(costs), m_hooks(std::move(hooks)) {
    connect(&m_motion, &PictureMotion::rested, this, &PictureFlow::want);
}

PictureFlow::~PictureFlow() = default;

void PictureFlow::report(const Error& error) {
    if (error.message() == m_error) {
        return;
    }
    m_error = error.message();
    // Not from within a paint event: whoever listens may open a dialog.
    QMetaObject::invokeMethod(
        this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
}

void PictureFlow::setQuality(const DisplayOptions& options, bool isMeasured) {
    const auto follow = [&] {
        m_refiner.setOn(!isMeasured);
        m_refiner.setWanted(options.refine ? kShownSamples : 0);
    };
    if (m_scene.exists()) {
        static_cast<void>(m_scene.with([&follow](SceneGpu&) -> Status {
            follow();
            return Done{};
        }));
    } else {
        follow();
    }
    m_motion.setOn(options.reduceInMotion && !isMeasured);
    m_ahead.setOn(m_surface.keepsPictures() && !isMeasured);
    // Only software renderers draw in parts, and only one picture.
    m_motion.setRefined(!isMeasured && m_scene.isSoftware() && !options.sideBySide &&
                        m_refiner.whyNot().isEmpty());
}

void PictureFlow::releaseGpu() {
    m_ahead.drop();
    m_kept = QImage();
    m_refiner.releaseGpu();
}

SceneGpu::View PictureFlow::begin() {
    m_sinceBegin.start();
    m_prepared = std::exchange(m_preparing, 0.0);
    m_follows = std::exchange(m_frameFollows, false) && m_sinceFrame.isValid();
    SceneGpu::View view = m_hooks.view();
    m_motion.seenFrom(view.camera.distance());
    view.detail = m_motion.beginFrame();
    // Where the CPU draws, keeping it costs a tenth of drawing it twice, and events wait meanwhile.
    view.isAtRest = m_scene.isSoftware() && !m_hooks.followsOn() && !m_motion.isMoving();
    return view;
}

void PictureFlow::begun() {
    m_motion.drawn(m_scene.get()->wasCoarse(), secondsOf(m_sinceBegin));
    Q_EMIT drawn();
}

/// Nothing is left to be done but to show it.
void PictureFlow::complete() {
    m_isDrawn = true;
    m_error.clear();
    if (const RefinedView* kept = m_refiner.view(); kept && (kept->wasShown() || kept->wasPatched())) {
        m_motion.keptShown(kept->isRough());
    }
    m_refiner.framePainted();
    // What was drawn before, in better quality, is no frame to measure.
    m_painted = m_refiner.wasShown() ? Painted::Nothing : m_follows ? Painted::Following : Painted::Alone;
}

/// Only now is a frame there: a renderer may have put off all of the drawing until now. The window is also
/// composed, and this called, where another widget has painted itself.
void PictureFlow::windowPainted() {
    if (!std::exchange(m_isDrawn, false)) {
        return;
    }
    const double drawing = m_prepared + secondsOf(m_sinceBegin);
    m_motion.frameShown(drawing);
    m_ahead.shown();
    Q_EMIT shown();
    const Painted painted = std::exchange(m_painted, Painted::Nothing);
    if (painted == Painted::Nothing) {
        return;
    }
    const bool follows = painted == Painted::Following && m_sinceFrame.isValid();
    const double seconds = follows ? secondsOf(m_sinceFrame) : drawing;
    m_sinceFrame.start();
    m_costs.endFrame(seconds, follows);
    Q_EMIT framePainted(seconds);
}

void PictureFlow::draw(unsigned framebuffer) {
    if (!m_scene.exists()) {
        return;
    }
    const Status drawn =
        m_scene.with([&](SceneGpu& scene) { return scene.draw(begin(), framebuffer, m_refiner.view()); });
    if (!drawn) {
        report(drawn.error());
        return;
    }
    begun();
    complete();
}

QImage PictureFlow::thumbnail(int width) {
    if (!m_kept.isNull()) {
        return m_kept.scaledToWidth(std::min(width, m_kept.width()), Qt::SmoothTransformation);
    }
    QImage small;
    static_cast<void>(m_scene.with([&](SceneGpu&) -> Status {
        const SceneGpu::View view = m_hooks.view();
        const Image read = hitscope::thumbnail(m_surface.framebuffer(), view.width, view.height, width);
        small = QImage(read.pixels.data(), read.width, read.height, 4 * read.width, QImage::Format_RGBX8888)
                    .copy();
        return Done{};
    }));
    return small;
}

PictureRefiner::Hooks PictureFlow::refinerHooks() {
    return {
        .mayRefine =
            [this] {
                return m_scene.exists() && !m_hooks.followsOn() && m_surface.widget().isVisible() &&
                       !m_motion.isReduced() && !m_ahead.isUnderWay();
            },
        .isBehind =
            [this](RefinedView& refined) {
                bool isBehind = false;
                static_cast<void>(m_scene.with([&](SceneGpu& scene) -> Status {
                    isBehind = scene.isBehindRefining(refined);
                    return Done{};
                }));
                return isBehind;
            },
        .addSample =
            [this](RefinedView& refined) {
                return m_scene.with([&](SceneGpu& scene) { return scene.refine(m_hooks.view(), refined); });
            },
        .isCoarse = [this] { return m_motion.lastDetail().coarse; },
        .show = [this] { want(); }};
}

}  // namespace hitscope
