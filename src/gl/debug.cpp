// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h>

#include <mutex>
#include <string_view>

#include "gl/context.h"

namespace hitscope::gl {
namespace {

constexpr std::size_t kMostMessages = 100;  // one bad call a frame must not fill the memory
constexpr int kMostErrorFlags = 16;         // a lost context reports errors for ever

struct Collected {
    std::mutex mutex;
    std::vector<std::string> messages;
};

Collected& collected() {
    static Collected instance;
    return instance;
}

void APIENTRY collect(GLenum source, GLenum type, GLuint /*id*/, GLenum /*severity*/, GLsizei length,
                      const GLchar* message, const void* /*user*/) {
    // What the shader compiler says is the build's result, not a wrong call: Program::build() reports it.
    if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) {
        return;
    }
    const std::string_view text =
        length < 0 ? std::string_view(message) : std::string_view(message, static_cast<std::size_t>(length));
    Collected& sink = collected();
    const std::lock_guard lock(sink.mutex);
    if (sink.messages.size() < kMostMessages) {
        sink.messages.emplace_back(text.substr(0, text.find_last_not_of(" \r\n") + 1));
    }
}

std::string errorName(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "GL error " + std::to_string(error);
    }
}

}  // namespace

void collectDebugMessages() {
    if (epoxy_gl_version() < 43 && !epoxy_has_gl_extension("GL_KHR_debug")) {
        return;
    }
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(collect, nullptr);
}

std::vector<std::string> takeErrors() {
    std::vector<std::string> messages;
    {
        Collected& source = collected();
        const std::lock_guard lock(source.mutex);
        messages.swap(source.messages);
    }
    // The same error arrives on both ways; debug output has the better words.
    const bool explained = !messages.empty();
    for (int i = 0; i < kMostErrorFlags; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) {
            break;
        }
        if (!explained) {
            messages.push_back(errorName(error));
        }
    }
    return messages;
}

}  // namespace hitscope::gl
