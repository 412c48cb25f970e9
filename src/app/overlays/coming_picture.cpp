// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/coming_picture.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>

#include "app/scene_files.h"
#include "view/coarse_picture.h"
#include "view/theme.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kCoarse = 2;     // pixels of the viewport across one of the picture's
constexpr int kWidest = 1280;  // pixels
constexpr int kSmallest = 16;  // pixels

QColor colourOf(const glm::vec3& srgb) {
    return QColor::fromRgbF(srgb.x, srgb.y, srgb.z);
}

}  // namespace

ComingPicture::ComingPicture(SceneFiles& files, Viewport& over) : QWidget(&over), m_viewport(over) {
    setObjectName(QStringLiteral("comingPicture"));
    hide();
    over.installEventFilter(this);
    files.setDrawing([this] { return [look = look()](const MeshData& mesh) { return draw(mesh, look); }; });
    connect(&files, &SceneFiles::seen, this, &ComingPicture::showPicture);
    connect(&files, &SceneFiles::ended, this, &ComingPicture::hideAfterFrame);
}

ComingPicture::Look ComingPicture::look() const {
    const qreal scale = m_viewport.devicePixelRatioF();
    return {m_viewport.camera(), (QSizeF(m_viewport.size()) * scale).toSize(),
            m_viewport.session().settings().lights().directional.direction};
}

QImage ComingPicture::draw(const MeshData& mesh, const Look& look) {
    const QSize size = look.size.scaled(std::min(look.size.width() / kCoarse, kWidest),
                                        look.size.height() / kCoarse, Qt::KeepAspectRatio);
    if (mesh.faceCount() < kLeastFaces || size.width() < kSmallest || size.height() < kSmallest) {
        return {};
    }
    // As the viewport is going to frame it: where it stands moves the camera along.
    const Bounds bounds = mesh.bounds();
    Camera camera = look.camera;
    camera.setSceneRadius(bounds.diagonal() > 0.0f ? bounds.diagonal() : 1.0f);
    camera.frame(bounds, static_cast<float>(look.size.width()) / static_cast<float>(look.size.height()));
    const Image image = drawCoarsely(mesh, camera, look.light, size.width(), size.height());
    return QImage(image.pixels.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888)
        .convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

void ComingPicture::showPicture(const QImage& picture) {
    m_picture = picture;
    setGeometry(m_viewport.rect());
    show();
    raise();
    update();
}

/// The frame may be that of the old scene, where the file was not opened after all.
void ComingPicture::hideAfterFrame() {
    if (!isVisible()) {
        return;
    }
    connect(
        &m_viewport.pictures(), &PictureFlow::framePainted, this,
        [this] {
            hide();
            m_picture = {};
        },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
    m_viewport.wantPicture();
}

bool ComingPicture::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize) {
        setGeometry(m_viewport.rect());
    }
    return QWidget::eventFilter(watched, event);
}

void ComingPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const ThemeColours& colours = themeColours(m_viewport.options().theme);
    QLinearGradient background(0.0, 0.0, 0.0, height());
    background.setColorAt(0.0, colourOf(colours.backgroundTop));
    background.setColorAt(1.0, colourOf(colours.backgroundBottom));
    painter.fillRect(rect(), background);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rect(), m_picture);
}

void ComingPicture::mousePressEvent(QMouseEvent* event) {
    event->accept();
}

void ComingPicture::wheelEvent(QWheelEvent* event) {
    event->accept();
}

}  // namespace hitscope
