// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <new>

#include "gl/context.h"

namespace hitscope::gl {
namespace {

constexpr const char* kAdvice =
    "Install Mesa's EGL and software drivers (Debian: apt install libegl1 libegl-mesa0 libgl1-mesa-dri).";

/// Displays that need no display server, best first: Mesa's surfaceless platform, each device of its own, and
/// whatever the driver's default is.
std::vector<EGLDisplay> candidateDisplays() {
    std::vector<EGLDisplay> displays;
    const bool platforms = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base");
    if (platforms && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    if (platforms && epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE) {
            for (EGLint i = 0; i < count; ++i) {
                displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                            devices[static_cast<std::size_t>(i)], nullptr));
            }
        }
    }
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

EGLConfig chooseConfig(EGLDisplay display) {
    constexpr std::array<EGLint, 5> kWanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                               EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, kWanted.data(), &config, 1, &count) == EGL_TRUE && count > 0) {
        return config;
    }
    return EGL_NO_CONFIG_KHR;
}

/// The newest core profile the display has, with debug output if possible.
EGLContext createContext(EGLDisplay display) {
    const EGLConfig config = chooseConfig(display);
    constexpr std::array<std::array<EGLint, 2>, 8> kVersions = {
        {{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}}};
    for (const std::array<EGLint, 2>& version : kVersions) {
        for (const EGLint flags : {EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR, 0}) {
            const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                                      version[0],
                                                      EGL_CONTEXT_MINOR_VERSION_KHR,
                                                      version[1],
                                                      EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                                      EGL_CONTEXT_FLAGS_KHR,
                                                      flags,
                                                      EGL_NONE};
            const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
            if (context != EGL_NO_CONTEXT) {
                return context;
            }
        }
    }
    return EGL_NO_CONTEXT;
}

/// A current context on `display`, or EGL_NO_CONTEXT.
EGLContext openOn(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE ||
        !epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        return EGL_NO_CONTEXT;
    }
    const EGLContext context = createContext(display);
    if (context == EGL_NO_CONTEXT) {
        return EGL_NO_CONTEXT;
    }
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
        eglDestroyContext(display, context);
        return EGL_NO_CONTEXT;
    }
    return context;
}

}  // namespace

Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create() {
    if (!epoxy_has_egl()) {
        return Error{"There is no EGL library, which drawing without a window needs.", "", kAdvice};
    }
    for (const EGLDisplay display : candidateDisplays()) {
        const EGLContext context = openOn(display);
        if (context != EGL_NO_CONTEXT) {
            std::unique_ptr<OffscreenContext> opened(new OffscreenContext);
            opened->m_display = display;
            opened->m_context = context;
            return opened;
        }
    }
    return Error{"No EGL driver here offers an OpenGL 3.3 core context without a window.", "", kAdvice};
}

// The display is not terminated: EGL hands out the same one again, and other contexts may live on it.
OffscreenContext::~OffscreenContext() {
    if (eglGetCurrentContext() == m_context) {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(m_display, m_context);
}

void OffscreenContext::makeCurrent() {
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context);
}

}  // namespace hitscope::gl
