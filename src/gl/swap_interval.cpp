// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/swap_interval.h"

#include <epoxy/egl.h>
#include <epoxy/glx.h>

namespace hitscope::gl {

namespace {

/// Nothing of ours is current in EGL: -1; else whether it could be set.
int setByEgl(int interval) {
    if (!epoxy_has_egl() || eglGetCurrentContext() == EGL_NO_CONTEXT) {
        return -1;
    }
    const bool window = eglGetCurrentSurface(EGL_DRAW) != EGL_NO_SURFACE;
    return window && eglSwapInterval(eglGetCurrentDisplay(), interval) == EGL_TRUE ? 1 : 0;
}

bool setByGlx(int interval) {
    Display* display = glXGetCurrentDisplay();
    const GLXDrawable window = glXGetCurrentDrawable();
    if (display == nullptr || window == 0) {
        return false;
    }
    const int screen = DefaultScreen(display);
    if (epoxy_has_glx_extension(display, screen, "GLX_EXT_swap_control")) {
        glXSwapIntervalEXT(display, window, interval);
        return true;
    }
    if (epoxy_has_glx_extension(display, screen, "GLX_MESA_swap_control")) {
        return glXSwapIntervalMESA(static_cast<unsigned>(interval)) == 0;
    }
    return false;
}

}  // namespace

bool setSwapInterval(int interval) {
    const int byEgl = setByEgl(interval);
    return byEgl >= 0 ? byEgl == 1 : setByGlx(interval);
}

}  // namespace hitscope::gl
