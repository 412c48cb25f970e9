// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to be seen, and pictures of it for others.
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/picture.h"
#include "viewport/viewport.h"

namespace hitscope {

SceneGpu::View Viewport::view() const {
    SceneGpu::View view;
    view.width = std::max(1, static_cast<int>(std::lround(width() * devicePixelRatioF())));
    view.height = std::max(1, static_cast<int>(std::lround(height() * devicePixelRatioF())));
    view.pixelRatio = static_cast<float>(devicePixelRatioF());
    view.camera = camera();
    view.options = m_options;
    view.ghost = m_decorations.ghost();
    view.section = m_decorations.section();
    view.otherSection = m_decorations.otherSection();
    view.showsCutPlane = m_decorations.showsCutPlane();
    view.changeValues = m_changeValues;
    view.comparison = m_comparison;
    view.projectilesFly = m_scene.isSoftware() && m_session.simulation().isMoving();
    view.options.crosshair = m_options.crosshair || m_trigger.showsCrosshair();
    return view;
}

Status Viewport::syncNow() {
    Status status = m_scene.with([](SceneGpu& scene) { return scene.sync(); });
    wantPicture();  // normals may have come with it
    return status;
}

PictureRequest Viewport::pictureRequest() const {
    const SceneGpu::View shown = view();
    return {.width = shown.width,
            .height = shown.height,
            .camera = m_navigation.goal(),
            .options = m_options,
            .changeValues = m_changeValues,
            .comparison = m_comparison,
            .otherSection = m_decorations.otherSection(),
            .labels = true};
}

Result<Image> Viewport::drawPicture(const PictureRequest& request) {
    return takePicture([&request](SceneGpu& scene) { return hitscope::drawPicture(scene, request); });
}

Result<Image> Viewport::drawShown() {
    return takePicture([this](SceneGpu& scene) -> Result<Image> {
        if (const Status current = scene.sync(); !current) {
            return current.error();
        }
        RefinedView* const refined = m_pictures.refiner().view();
        return refined != nullptr && scene.isRefined(view(), *refined)
                   ? hitscope::drawPicture(scene, pictureRequest(), *refined)
                   : hitscope::drawPicture(scene, pictureRequest());
    });
}

Result<Image> Viewport::takePicture(const std::function<Result<Image>(SceneGpu&)>& draw) {
    Image image;
    const Status status = m_scene.with([&](SceneGpu& scene) -> Status {
        Result<Image> drawn = draw(scene);
        if (!drawn) {
            return drawn.error();
        }
        image = std::move(drawn).value();
        return Done{};
    });
    if (!status) {
        return status.error();
    }
    wantPicture();
    return image;
}

void Viewport::paintOver(QPaintDevice& picture) {
    if (!m_scene.exists()) {
        paintError(picture);
    } else if (const SceneGpu::View drawn = view(); ChangeOverlay::isNeeded(drawn)) {
        QPainter painter(&picture);
        m_changeOverlay.paint(painter, drawn);
    }
}

void Viewport::paintError(QPaintDevice& picture) {
    const std::string& error = m_pictures.error();
    QPainter painter(&picture);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     error.empty() ? tr("Nothing can be drawn.") : QString::fromStdString(error));
}

}  // namespace hitscope
