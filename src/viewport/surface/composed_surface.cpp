// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/composed_surface.h"

#include <QShowEvent>
#include <utility>

#include "viewport/surface/surface_format.h"

namespace hitscope {

ComposedSurface::ComposedSurface(QWidget& viewport, Hooks hooks)
    : QOpenGLWidget(&viewport), m_hooks(std::move(hooks)), m_wanted(viewportFormat()) {
    setFormat(m_wanted);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] { m_hooks.shown(); });
}

/// Qt forgets the samples once it has made a context, so that each one needs the format anew.
bool ComposedSurface::event(QEvent* event) {
    if (event->type() == QEvent::Show && !isValid()) {
        setFormat(m_wanted);
    }
    if (event->type() == QEvent::WindowChangeInternal && isValid() && !isHidden()) {
        return moveToWindow(event);
    }
    return QOpenGLWidget::event(event);
}

/// In a window that is shown already, Qt makes the next context at once. A hidden widget only loses the old
/// one.
bool ComposedSurface::moveToWindow(QEvent* event) {
    setAttribute(Qt::WA_WState_Hidden);
    const bool handled = QOpenGLWidget::event(event);
    setAttribute(Qt::WA_WState_Hidden, false);
    if (isValid()) {
        return handled;  // contexts are shared, and it keeps its own
    }
    setFormat(m_wanted);
    QShowEvent shown;
    return QOpenGLWidget::event(&shown);
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
