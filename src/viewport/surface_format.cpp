// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface_format.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <optional>
#include <utility>

#include "gl/context.h"

namespace hitscope {

namespace {

constexpr int kSamples = 4;
constexpr std::pair kNeeded(3, 3);  // OpenGL version

/// What a context of the base format is; nothing where there is none.
const std::optional<gl::RendererInfo>& driver() {
    static const std::optional<gl::RendererInfo> info = []() -> std::optional<gl::RendererInfo> {
        QOpenGLContext context;
        context.setFormat(baseSurfaceFormat());
        QOffscreenSurface surface;
        surface.setFormat(baseSurfaceFormat());
        surface.create();
        if (!context.create() || !context.makeCurrent(&surface)) {
            return std::nullopt;
        }
        gl::RendererInfo found = gl::rendererInfo();
        context.doneCurrent();
        return found;
    }();
    return info;
}

}  // namespace

QSurfaceFormat baseSurfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(kNeeded.first, kNeeded.second);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    return format;
}

QSurfaceFormat viewportFormat() {
    QSurfaceFormat format = baseSurfaceFormat();
    const bool software = driver() && driver()->isSoftware();
    format.setSamples(software ? 0 : kSamples);
    return format;
}

Status checkOpenGl() {
    if (driver() && std::pair(driver()->major, driver()->minor) >= kNeeded) {
        return Done{};
    }
    return Error{"Hitscope's window needs OpenGL 3.3, and there is none here.",
                 driver() ? driver()->renderer + ' ' + driver()->version : "",
                 "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1 to draw in software."};
}

}  // namespace hitscope
