// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/raster_surface.h"

#include <QBackingStore>
#include <QPainter>
#include <utility>

#include "viewport/surface/surface_format.h"

namespace hitscope {

RasterSurface::RasterSurface(QWidget& viewport, Hooks hooks) : QWidget(&viewport), m_hooks(std::move(hooks)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

RasterSurface::~RasterSurface() = default;

bool RasterSurface::make() {
    if (m_context) {
        return true;
    }
    auto context = std::make_unique<QOpenGLContext>();
    context->setFormat(viewportFormat());
    m_surface.setFormat(viewportFormat());
    m_surface.create();
    if (!context->create() || !context->makeCurrent(&m_surface)) {
        return false;
    }
    m_context = std::move(context);
    m_hooks.made();
    doneCurrent();
    return true;
}

void RasterSurface::makeCurrent() {
    if (m_context) {
        m_context->makeCurrent(&m_surface);
    }
}

void RasterSurface::doneCurrent() {
    if (m_context) {
        m_context->doneCurrent();
    }
}

void RasterSurface::resizeEvent(QResizeEvent*) {
    if (make()) {
        makeCurrent();
        m_hooks.resized();
        doneCurrent();
    }
}

bool RasterSurface::showNow() {
    m_isPainted = false;
    repaint();
    return m_isPainted;
}

/// Else somebody renders it into something of their own.
bool RasterSurface::isPaintedByWindow() const {
    const QBackingStore* const store = backingStore();
    return store != nullptr && redirected(nullptr) == const_cast<QBackingStore*>(store)->paintDevice();
}

void RasterSurface::paintEvent(QPaintEvent*) {
    const bool byWindow = isPaintedByWindow();
    make();
    {
        const QImage picture = m_hooks.kept(byWindow);
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        if (picture.isNull()) {
            painter.fillRect(rect(), palette().color(QPalette::Window));
        } else {
            painter.drawImage(rect(), picture);
        }
    }
    m_hooks.paintOver(*this);
    if (byWindow) {
        m_isPainted = true;
        // What was painted is on the screen once this event is over.
        QMetaObject::invokeMethod(
            this, [this] { m_hooks.shown(); }, Qt::QueuedConnection);
    }
}

QImage RasterSurface::grab() {
    QImage picture = m_hooks.kept(false);
    if (const QSize pixels = (devicePixelRatioF() * QSizeF(size())).toSize();
        !picture.isNull() && picture.size() != pixels) {
        picture = picture.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    if (!picture.isNull()) {
        picture.setDevicePixelRatio(devicePixelRatioF());
        m_hooks.paintOver(picture);
    }
    return picture;
}

}  // namespace hitscope
