// SPDX-License-Identifier: GPL-3.0-or-later
// The viewport and what shows its pictures: the context comes and goes, a picture is drawn for it or kept.
#include <QOpenGLContext>
#include <QPainter>
#include <utility>

#include "gl/context.h"
#include "scene/scene_picker.h"
#include "viewport/surface/side_thread.h"
#include "viewport/viewport.h"

namespace hitscope {

PictureSurface::Hooks Viewport::surfaceHooks() {
    return {.made = [this] { surfaceMade(); },
            .resized = [this] { surfaceResized(); },
            .draw = [this](unsigned framebuffer) { draw(framebuffer); },
            .kept = [this](bool byWindow) { return kept(byWindow); },
            .paintOver = [this](QPaintDevice& picture) { paintOver(picture); },
            .shown =
                [this] {
                    endFrame();
                    followRefresh();
                    Q_EMIT windowPainted();
                    if (isCatchingUp()) {
                        m_catchUp.sliceLater();
                    } else {
                        moveOn();
                    }
                }};
}

void Viewport::resizeEvent(QResizeEvent*) {
    m_surface.widget().setGeometry(rect());
}

void Viewport::surfaceMade() {
    // The context may go when the widget is moved to another window, and takes all GL objects with it.
    connect(m_surface.context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseGpu,
            Qt::DirectConnection);
    m_unlimited = false;  // another context, perhaps in another window
    const gl::RendererInfo info = gl::rendererInfo();
    m_rendererName = QString::fromStdString(info.renderer);
    m_isSoftware = info.isSoftware();
    m_motion.setLongestFrame(m_isSoftware ? MotionDetail::kLongestSoftwareFrame
                                          : MotionDetail::kLongestFrame);
    followSize();
    m_rendererVersion = QString::fromStdString(info.version);
    Result<std::unique_ptr<SceneGpu>> scene = SceneGpu::create(m_session);
    if (scene) {
        m_scene = std::move(scene).value();
        m_scene->setAppliesBetweenPictures(m_isSoftware);
        if (m_isSoftware) {  // it clears whole buffers at once; not every GPU's driver bears two threads
            m_scene->bringBeside([this] { return SideThread::create(*m_surface.context()); });
        }
        m_picking.setPicker(std::make_unique<ScenePicker>(m_session, *m_scene));
        m_error.clear();
        followQuality();
        m_trialTimer.start();
    } else {
        report(scene.error());
    }
    Q_EMIT rendererKnown();
}

void Viewport::releaseGpu() {
    if (m_surface.context() != nullptr) {
        disconnect(m_surface.context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseGpu);
    }
    m_ahead.drop();
    m_kept = QImage();
    if (m_scene) {
        m_trialTimer.stop();
        m_surface.makeCurrent();
        Q_EMIT aboutToReleaseGpu();
        m_refiner.releaseGpu();
        m_picking.setPicker(nullptr);
        m_scene.reset();
        m_surface.doneCurrent();
    }
}

void Viewport::surfaceResized() {
    followViewSize();
    m_motion.forget();
    if (!m_framed) {
        m_framed = true;
        frameAll(Navigation::Arrival::AtOnce);
    }
}

void Viewport::draw(unsigned framebuffer) {
    if (!m_scene) {
        return;
    }
    const SceneGpu::View shown = beginPicture();
    if (Status drawn = m_scene->draw(shown, framebuffer, m_refiner.view()); !drawn) {
        report(drawn.error());
        return;
    }
    pictureBegun();
    pictureComplete();
}

/// A window that paints itself shows the last picture: what has changed since comes with the next one.
QImage Viewport::kept(bool byWindow) {
    if (byWindow && m_ahead.isOn() && !m_kept.isNull()) {
        const SceneGpu::View shown = view();
        if (m_keptFor != QSize(shown.width, shown.height)) {
            wantPicture();
        }
    } else if (m_scene) {
        const bool wasWanted = m_ahead.drawn();
        if (const Status drawn = withScene([this](SceneGpu& scene) -> Status { return drawKept(scene); });
            !drawn) {
            report(drawn.error());
        } else if (!byWindow && wasWanted) {
            m_surface.widget().update();
        }
    }
    return m_kept;
}

Status Viewport::drawKept(SceneGpu& scene) {
    const Result<bool> begun = scene.drawAhead(beginPicture(), m_refiner.view());
    if (!begun) {
        return begun.error();
    }
    if (!begun.value()) {
        return Error{"There is no memory for a picture of the viewport's size.", "",
                     "Make the window smaller."};
    }
    pictureBegun();
    readKept(scene);
    return Done{};
}

void Viewport::readKept(SceneGpu& scene) {
    const auto [width, height] = scene.aheadSize();
    if (m_kept.size() != QSize(width, height)) {
        m_kept = QImage(width, height, QImage::Format_RGB32);
    }
    if (!scene.readAhead(m_kept.bits(), m_refiner.view())) {
        m_kept = QImage();  // it is drawn anew where the window is painted
    }
    const SceneGpu::View shown = view();
    m_keptFor = QSize(shown.width, shown.height);
    pictureComplete();
}

/// Nothing is left to be done but to show it.
void Viewport::pictureComplete() {
    m_isDrawn = true;
    m_error.clear();
    if (const RefinedView* kept = m_refiner.view(); kept && (kept->wasShown() || kept->wasPatched())) {
        m_motion.keptShown(kept->isRough());
    }
    m_refiner.framePainted();
    // What was drawn before, in better quality, is no frame to measure.
    m_painted = m_refiner.wasShown() ? Painted::Nothing : m_follows ? Painted::Following : Painted::Alone;
}

void Viewport::paintOver(QPaintDevice& picture) {
    if (!m_scene) {
        paintError(picture);
        return;
    }
    const SceneGpu::View drawn = view();
    if (ChangeOverlay::isNeeded(drawn)) {
        QPainter painter(&picture);
        m_changeOverlay.paint(painter, drawn);
    }
}

void Viewport::paintError(QPaintDevice& picture) {
    QPainter painter(&picture);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     m_error.empty() ? tr("Nothing can be drawn.") : QString::fromStdString(m_error));
}

}  // namespace hitscope
