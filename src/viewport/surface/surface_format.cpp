// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/surface_format.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <array>
#include <optional>
#include <utility>

#include "gl/context.h"

namespace hitscope {

namespace {

constexpr int kSamples = 4;

using Version = std::pair<int, int>;  // of OpenGL
constexpr Version kNeeded(3, 3);
constexpr Version kCompute(4, 3);  // compute shaders came with it
/// Newest first.
constexpr std::array kNewer = {Version(4, 6), Version(4, 5), kCompute};

/// What contexts are asked for.
Version& askedFor() {
    static Version version = kNeeded;
    return version;
}

/// What a context of the base format is; nothing where there is none.
std::optional<gl::RendererInfo> tryBaseFormat() {
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
}

Version versionOf(const gl::RendererInfo& info) {
    return {info.major, info.minor};
}

/// Mesa's drivers give the newest version that they have, whatever older one is asked for. Others give just
/// what is asked for, as NVIDIA's does.
std::optional<gl::RendererInfo> findNewest() {
    std::optional<gl::RendererInfo> best = tryBaseFormat();
    for (const Version& newer : kNewer) {
        if (!best || versionOf(*best) >= kCompute) {
            break;
        }
        const Version before = std::exchange(askedFor(), newer);
        std::optional<gl::RendererInfo> found = tryBaseFormat();
        if (found && versionOf(*found) > versionOf(*best)) {
            best = std::move(found);
        } else {
            askedFor() = before;
        }
    }
    QSurfaceFormat::setDefaultFormat(baseSurfaceFormat());  // no context that stays has been made with it yet
    return best;
}

const std::optional<gl::RendererInfo>& driver() {
    static const std::optional<gl::RendererInfo> info = findNewest();
    return info;
}

}  // namespace

QSurfaceFormat baseSurfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(askedFor().first, askedFor().second);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    return format;
}

bool isDrawnByCpu() {
    return driver() && driver()->isSoftware();
}

QSurfaceFormat viewportFormat() {
    const int samples = isDrawnByCpu() ? qEnvironmentVariableIntValue(kComposes) : kSamples;
    QSurfaceFormat format = baseSurfaceFormat();  // once the driver has been asked
    format.setSamples(samples > 1 ? samples : 0);
    return format;
}

Status checkOpenGl() {
    if (driver() && versionOf(*driver()) >= kNeeded) {
        return Done{};
    }
    return Error{"Hitscope's window needs OpenGL 3.3, and there is none here.",
                 driver() ? driver()->renderer + ' ' + driver()->version : "",
                 "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1 to draw in software."};
}

}  // namespace hitscope
