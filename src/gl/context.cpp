// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/context.h"

#include <epoxy/gl.h>

namespace hitscope::gl {
namespace {

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(value));
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace

RendererInfo rendererInfo() {
    RendererInfo info;
    info.vendor = text(GL_VENDOR);
    info.renderer = text(GL_RENDERER);
    info.version = text(GL_VERSION);
    info.major = integer(GL_MAJOR_VERSION);
    info.minor = integer(GL_MINOR_VERSION);
    info.maxVertexUniformComponents = integer(GL_MAX_VERTEX_UNIFORM_COMPONENTS);
    return info;
}

void finish() {
    glFinish();
}

bool RendererInfo::isSoftware() const {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "SWR"}) {
        if (renderer.find(name) != std::string::npos) {
            return true;
        }
    }
    return false;
}

}  // namespace hitscope::gl
