// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that are kept in memory, and drawn ahead of the window's painting.
#include <QWidget>

#include "scene/refined_view.h"
#include "viewport/picture_flow.h"
#include "viewport/surface/picture_surface.h"
#include "viewport/viewport_scene.h"

namespace hitscope {

PictureAhead::Hooks PictureFlow::aheadHooks() {
    return {.prepare = [this] { return prepareAhead(); },
            .begin = [this] { return beginAhead(); },
            .isFinished =
                [this] {
                    bool isDrawn = true;  // where the scene is gone, nothing comes of waiting
                    static_cast<void>(m_scene.with([&isDrawn](SceneGpu& scene) -> Status {
                        isDrawn = scene.isDrawnAhead();
                        return Done{};
                    }));
                    return isDrawn;
                },
            .show = [this] { return showAhead(); },
            .paint = [this] { m_surface.widget().update(); }};
}

bool PictureFlow::prepareAhead() {
    QElapsedTimer clock;
    clock.start();
    bool isPrepared = true;  // where it fails, drawing does too, and says so
    static_cast<void>(m_scene.with([&](SceneGpu& scene) -> Status {
        SceneGpu::View coming = m_hooks.view();
        coming.detail = m_motion.coming();
        const Result<bool> prepared = scene.prepare(coming, m_refiner.view());
        isPrepared = !prepared || prepared.value();
        return Done{};
    }));
    m_preparing += static_cast<double>(clock.nsecsElapsed()) * 1.0e-9;
    return isPrepared;
}

bool PictureFlow::beginAhead() {
    bool isBegun = false;
    const Status drawn = m_scene.with([&](SceneGpu& scene) -> Status {
        const Result<bool> ahead = scene.drawAhead(begin(), m_refiner.view());
        if (!ahead) {
            return ahead.error();
        }
        isBegun = ahead.value();
        return Done{};
    });
    if (drawn && isBegun) {
        begun();
    } else {
        m_kept = QImage();  // painting finds the same, and reports it
    }
    return drawn && isBegun;
}

bool PictureFlow::showAhead() {
    static_cast<void>(m_scene.with([this](SceneGpu& scene) -> Status {
        readKept(scene);
        return Done{};
    }));
    return m_surface.showNow();
}

/// A window that paints itself shows the last picture: what has changed since comes with the next one.
QImage PictureFlow::kept(bool byWindow) {
    if (byWindow && m_ahead.isOn() && !m_kept.isNull()) {
        const SceneGpu::View view = m_hooks.view();
        if (m_keptFor != QSize(view.width, view.height)) {
            want();
        }
    } else if (m_scene.exists()) {
        const bool wasWanted = m_ahead.drawn();
        if (const Status drawn = m_scene.with([this](SceneGpu& scene) { return drawKept(scene); }); !drawn) {
            report(drawn.error());
        } else if (!byWindow && wasWanted) {
            m_surface.widget().update();
        }
    }
    return m_kept;
}

Status PictureFlow::drawKept(SceneGpu& scene) {
    const Result<bool> ahead = scene.drawAhead(begin(), m_refiner.view());
    if (!ahead) {
        return ahead.error();
    }
    if (!ahead.value()) {
        return Error{"There is no memory for a picture of the viewport's size.", "",
                     "Make the window smaller."};
    }
    begun();
    readKept(scene);
    return Done{};
}

void PictureFlow::readKept(SceneGpu& scene) {
    const auto [width, height] = scene.aheadSize();
    if (m_kept.size() != QSize(width, height)) {
        m_kept = QImage(width, height, QImage::Format_RGB32);
    }
    if (!scene.readAhead(m_kept.bits(), m_refiner.view())) {
        m_kept = QImage();  // it is drawn anew where the window is painted
    }
    const SceneGpu::View view = m_hooks.view();
    m_keptFor = QSize(view.width, view.height);
    complete();
}

}  // namespace hitscope
