// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>

#include "viewport/surface/picture_surface.h"

namespace hitscope {

/// Qt composes the window of its texture and of all other widgets by OpenGL.
class ComposedSurface : public QOpenGLWidget, public PictureSurface {
    Q_OBJECT
public:
    ComposedSurface(QWidget& viewport, Hooks hooks);

    QWidget& widget() override { return *this; }
    QOpenGLContext* context() const override { return QOpenGLWidget::context(); }
    void makeCurrent() override { QOpenGLWidget::makeCurrent(); }
    void doneCurrent() override { QOpenGLWidget::doneCurrent(); }
    QImage grab() override { return grabFramebuffer(); }
    bool keepsPictures() const override { return false; }
    unsigned framebuffer() const override { return defaultFramebufferObject(); }

protected:
    bool event(QEvent* event) override;
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;

private:
    bool moveToWindow(QEvent* event);

    Hooks m_hooks;
    QSurfaceFormat m_wanted;
};

}  // namespace hitscope
