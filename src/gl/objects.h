// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace hitscope::gl {

/// Owns one GL name; Traits::create and Traits::destroy make and give back. Move-only. Must be destroyed with
/// the context that made it current.
template <class Traits>
class Object {
public:
    Object() = default;
    [[nodiscard]] static Object make() { return Object(Traits::create()); }
    ~Object() { reset(); }
    Object(Object&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
    Object& operator=(Object&& other) noexcept {
        if (this != &other) {
            reset();
            m_id = std::exchange(other.m_id, 0);
        }
        return *this;
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    [[nodiscard]] GLuint id() const { return m_id; }
    explicit operator bool() const { return m_id != 0; }
    void reset() {
        if (m_id != 0) {
            Traits::destroy(std::exchange(m_id, 0));
        }
    }

private:
    explicit Object(GLuint id) : m_id(id) {}
    GLuint m_id = 0;
};

struct BufferTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct VertexArrayTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct TextureTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct FramebufferTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct RenderbufferTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct SamplerTraits {
    static GLuint create();
    static void destroy(GLuint id);
};
struct QueryTraits {
    static GLuint create();
    static void destroy(GLuint id);
};

using Buffer = Object<BufferTraits>;
using VertexArray = Object<VertexArrayTraits>;
using Texture = Object<TextureTraits>;
using Framebuffer = Object<FramebufferTraits>;
using Renderbuffer = Object<RenderbufferTraits>;
using Sampler = Object<SamplerTraits>;
using Query = Object<QueryTraits>;

}  // namespace hitscope::gl
