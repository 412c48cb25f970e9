// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface_format.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "gl/context.h"

namespace hitscope {

namespace {

constexpr int kSamples = 4;

bool drawsInSoftware(const QSurfaceFormat& format) {
    QOpenGLContext context;
    context.setFormat(format);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    if (!context.create() || !context.makeCurrent(&surface)) {
        return false;  // the viewport will say what is wrong
    }
    const bool software = gl::rendererInfo().isSoftware();
    context.doneCurrent();
    return software;
}

}  // namespace

QSurfaceFormat viewportFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    static const bool software = drawsInSoftware(format);
    format.setSamples(software ? 0 : kSamples);
    return format;
}

}  // namespace hitscope
