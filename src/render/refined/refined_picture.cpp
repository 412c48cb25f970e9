// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/refined/refined_picture.h"

#include <cmath>
#include <cstdint>
#include <glm/gtc/constants.hpp>

#include "render/refined/varying_area.h"

namespace hitscope {
namespace {

/// The number's digits to that base, behind the point in turned order (van der Corput).
float turned(int number, int base) {
    float result = 0.0f;
    float digit = 1.0f;
    for (; number > 0; number /= base) {
        digit /= static_cast<float>(base);
        result += digit * static_cast<float>(number % base);
    }
    return result;
}

/// The second of Sobol's sequences, [0, 1); with the first, turned(number, 2), each part of the square gets
/// its share.
float sobol(int number) {
    std::uint32_t result = 0;
    std::uint32_t direction = 1u << 31;
    for (; number > 0; number /= 2, direction ^= direction >> 1) {
        result ^= number % 2 != 0 ? direction : 0;
    }
    return static_cast<float>(static_cast<double>(result) / 4294967296.0);
}

float fraction(double value) {
    return static_cast<float>(value - std::floor(value));
}

gl::Texture makeTexture(GLint format, GLenum pixels, GLenum type, int width, int height) {
    gl::Texture texture = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, pixels, type, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
    }
    return texture;
}

/// depth: 0 for none.
gl::Framebuffer makeFramebuffer(GLuint colour, GLuint depthTexture) {
    gl::Framebuffer framebuffer = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour, 0);
    if (depthTexture != 0) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depthTexture, 0);
    }
    return framebuffer;
}

bool isComplete(const gl::Framebuffer& framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

RefinedPicture::Sample RefinedPicture::sampleAt(int index) {
    constexpr double kPlastic = 0.7548776662466927;
    constexpr float kMiddle = 0.5f - 0.5f / static_cast<float>(kUsualSamples);  // the mean of the usual ones
    constexpr double kGolden = 0.6180339887498949;
    Sample sample;
    sample.jitter = glm::vec2(turned(index, 2), sobol(index)) - kMiddle;
    const float out = std::sqrt(turned(index + 1, 2));
    const float angle = glm::two_pi<float>() * turned(index + 1, 3);
    sample.light = {out * std::cos(angle), out * std::sin(angle)};
    sample.turn = {fraction(kGolden * index), fraction(kPlastic * index)};
    return sample;
}

void RefinedPicture::clear() {
    m_samples = 0;
    m_hasDepths = false;
    m_nextPart = 0;
}

void RefinedPicture::begin(const PixelArea& varying) {
    m_area = m_extent == Extent::Everywhere ? PixelArea{0, 0, m_width, m_height} : varying;
    m_hasDepths = true;
}

bool RefinedPicture::prepare(int width, int height) {
    if (width == m_width && height == m_height) {
        return true;
    }
    clear();
    m_colour = makeTexture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
    m_depths = makeTexture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height);
    m_sum = makeTexture(GL_RGBA32F, GL_RGBA, GL_FLOAT, width, height);
    for (gl::Texture& floor : m_floor) {
        floor = makeTexture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    m_sampleDepth = gl::Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, m_sampleDepth.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    m_plain = makeFramebuffer(m_colour.id(), m_depths.id());
    m_sample = makeFramebuffer(m_colour.id(), 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_sampleDepth.id());
    m_adding = makeFramebuffer(m_sum.id(), 0);
    for (std::size_t i = 0; i < m_floor.size(); ++i) {
        m_drawnFloor[i] = makeFramebuffer(m_floor[i].id(), 0);
    }
    const bool made = isComplete(m_plain) && isComplete(m_sample) && isComplete(m_adding) &&
                      isComplete(m_drawnFloor[0]) && isComplete(m_drawnFloor[1]);
    m_width = made ? width : 0;
    m_height = made ? height : 0;
    return made;
}

Status RefinedPicture::add(render::ProgramCache& programs, GLuint emptyArray) {
    const auto found = programs.get("refined.vert", "refined.frag");
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    glBindFramebuffer(GL_FRAMEBUFFER, m_adding.id());
    glViewport(0, 0, m_width, m_height);
    render::limitDrawing(m_area);
    glDisable(GL_DEPTH_TEST);
    if (m_samples > 0) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    } else {
        glDisable(GL_BLEND);
    }
    program.use();
    program.set("u_picture", 0);
    program.set("u_share", 1.0f);
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
    glBindTexture(GL_TEXTURE_2D, m_colour.id());
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, 0);
    ++m_samples;
    return Done{};
}

Status RefinedPicture::draw(render::ProgramCache& programs, GLuint emptyArray, bool withDepths) const {
    const auto found = programs.get("refined.vert", "refined.frag",
                                    withDepths ? gl::Defines{{"HITSCOPE_DEPTHS", "1"}} : gl::Defines{});
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_picture", 0);
    program.set("u_depths", 1);
    const auto bind = [](int unit, const gl::Texture& texture) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindSampler(static_cast<GLuint>(unit), 0);
        glBindTexture(GL_TEXTURE_2D, texture.id());
    };
    bind(1, m_depths);
    glDisable(GL_BLEND);
    // Depths are written only where the test is on.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(withDepths ? GL_TRUE : GL_FALSE);
    glBindVertexArray(emptyArray);
    bind(0, m_colour);
    program.set("u_share", 1.0f);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (m_samples > 0) {
        bind(0, m_sum);
        program.set("u_share", 1.0f / static_cast<float>(m_samples));
        render::limitDrawing(m_area);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDisable(GL_SCISSOR_TEST);
    }
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    return Done{};
}

}  // namespace hitscope
