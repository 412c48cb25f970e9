// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/composed_surface.h"

#include <QEvent>
#include <utility>

#include "viewport/surface/surface_format.h"

namespace hitscope {

ComposedSurface::ComposedSurface(QWidget& viewport, Hooks hooks)
    : QOpenGLWidget(&viewport), m_hooks(std::move(hooks)) {
    setFormat(viewportFormat());
    setAttribute(Qt::WA_TransparentForMouseEvents);
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] { m_hooks.shown(); });
}

bool ComposedSurface::event(QEvent* event) {
    if (event->type() == QEvent::Show && !isValid()) {
        setFormat(viewportFormat());  // Qt forgets the samples once it has made a context
    }
    return QOpenGLWidget::event(event);
}

void ComposedSurface::initializeGL() {
    m_hooks.made();
}

void ComposedSurface::resizeGL(int, int) {
    m_hooks.resized();
}

void ComposedSurface::paintGL() {
    m_hooks.draw(defaultFramebufferObject());
    m_hooks.paintOver(*this);
}

}  // namespace hitscope
