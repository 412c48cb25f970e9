// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pick_pass.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "render/change_map.h"
#include "render/cut_away.h"
#include "render/gl_state.h"
#include "render/seen/drawn_bounds.h"

namespace hitscope {

namespace {

/// As the fragment programs write it: nothing is target 0.
struct Pixel {
    std::uint32_t target;
    std::uint32_t element;
};
static_assert(sizeof(Pixel) == 8);

std::vector<PickedElement> unpack(std::span<const Pixel> pixels) {
    std::vector<PickedElement> elements(pixels.size());
    std::transform(pixels.begin(), pixels.end(), elements.begin(), [](const Pixel& pixel) {
        return PickedElement{TargetId{pixel.target}, pixel.element};
    });
    return elements;
}

/// The area and two pixels around it, which is more than points and rounding can reach.
render::PictureWindow windowOf(const PixelArea& area, const Frame& frame) {
    constexpr float kMargin = 2.0f;
    const glm::vec2 low(area.x, area.y);
    const glm::vec2 size(area.width, area.height);
    const glm::vec2 picture(frame.width, frame.height);
    return {2.0f * (low - kMargin) / picture - 1.0f, 2.0f * (low + size + kMargin) / picture - 1.0f};
}

void prepareState() {
    for (const GLenum capability : {GL_STENCIL_TEST, GL_CULL_FACE, GL_BLEND, GL_SCISSOR_TEST,
                                    GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP}) {
        glDisable(capability);
    }
    glEnable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_PROGRAM_POINT_SIZE);
    const GLuint nothing[4] = {};
    const GLfloat farthest = 1.0f;
    glClearBufferuiv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

}  // namespace

PickPass::~PickPass() = default;

/// The framebuffer is bound.
Status PickPass::makeRoom(const PixelArea& area) {
    if (area.width <= m_width && area.height <= m_height) {
        return Done{};
    }
    m_width = std::max(m_width, area.width);
    m_height = std::max(m_height, area.height);
    m_elements = gl::Renderbuffer::make();
    m_depth = gl::Renderbuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, m_elements.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RG32UI, m_width, m_height);
    glBindRenderbuffer(GL_RENDERBUFFER, m_depth.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, m_width, m_height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_elements.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth.id());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        m_width = m_height = 0;
        return Error{"The driver has no room to tell what the cursor points at.", "",
                     "Make the window smaller."};
    }
    return Done{};
}

void PickPass::setWay(bool byGeometry, gl::Defines defines) {
    m_byGeometry = byGeometry;
    m_defines = std::move(defines);
}

Result<const gl::Program*> PickPass::programFor(const Frame& frame, const DeformationPipeline& pipeline,
                                                bool points, bool filled) {
    gl::Defines defines = render::targetDefines(frame, pipeline);
    defines.insert(defines.end(), m_defines.begin(), m_defines.end());
    if (filled) {
        defines.emplace_back("HITSCOPE_CUT_FILLED", "1");
    }
    if (!m_byGeometry) {
        return m_programs.get("surface.vert", "pick.frag", defines);
    }
    defines.emplace_back("HITSCOPE_HANDED_ON", "1");
    if (points) {
        defines.emplace_back("HITSCOPE_POINTS", "1");
    }
    return m_programs.get("surface.vert", "pick.frag", defines, "pick.geom");
}

Status PickPass::draw(const Frame& frame, DeformationPipeline& pipeline, const PixelArea& area,
                      PickElements elements) {
    const bool points = elements == PickElements::Points;
    const bool filled = !points && render::isCutFilled(frame);
    const auto found = programFor(frame, pipeline, points, filled);
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    const render::KeepState keep;
    if (!m_framebuffer) {
        m_framebuffer = gl::Framebuffer::make();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    if (Status status = makeRoom(area); !status) {
        return status;
    }
    m_drawn = area;
    // The picture's pixels, moved by whole ones: they cover what they cover there.
    glViewport(-area.x, -area.y, frame.width, frame.height);
    prepareState();
    program.use();
    const float aspect = static_cast<float>(frame.width) / static_cast<float>(frame.height);
    const glm::mat4 viewProjection = frame.camera.projection(aspect) * frame.camera.view();
    program.set("u_viewProjection", viewProjection);
    render::setDrawnPlace(program, frame);
    if (filled) {
        program.set("u_eye", frame.camera.eye());
        render::setCutFill(program, frame);
    }
    const GLint target = program.location("u_target");
    const render::ClipByCut clip(frame);
    const render::PictureWindow window = windowOf(area, frame);
    for (const DrawItem& item : frame.targets) {
        if (!render::mayShow(item, frame, pipeline, viewProjection, window)) {
            continue;
        }
        pipeline.prepareDraw(program, item.target);
        program.set("u_model", item.model);
        glUniform1ui(target, item.target.value);
        glBindVertexArray(item.original ? item.buffers->originalSurfaceArray()
                                        : item.buffers->surfaceArray());
        if (points) {
            glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(item.buffers->drawnVertexCount()));
        } else {
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(item.buffers->triangleIndexCount()),
                           GL_UNSIGNED_INT, nullptr);
        }
    }
    return Done{};
}

std::vector<PickedElement> PickPass::read() {
    const render::KeepState keep;
    std::vector<Pixel> pixels(static_cast<std::size_t>(m_drawn.width) *
                              static_cast<std::size_t>(m_drawn.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, m_drawn.width, m_drawn.height, GL_RG_INTEGER, GL_UNSIGNED_INT, pixels.data());
    return unpack(pixels);
}

void PickPass::startReading() {
    const render::KeepState keep;
    m_fence.reset();
    if (!m_copy) {
        m_copy = gl::Buffer::make();
    }
    m_copied = static_cast<std::size_t>(m_drawn.width) * static_cast<std::size_t>(m_drawn.height);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_copy.id());
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(m_copied * sizeof(Pixel)), nullptr,
                 GL_STREAM_READ);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, m_drawn.width, m_drawn.height, GL_RG_INTEGER, GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    m_fence.emplace();
}

std::optional<std::vector<PickedElement>> PickPass::takeArrived() {
    if (!m_fence || !m_fence->isPassed()) {
        return std::nullopt;
    }
    m_fence.reset();
    std::vector<Pixel> pixels(m_copied);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_copy.id());
    const auto bytes = static_cast<GLsizeiptr>(m_copied * sizeof(Pixel));
    if (const void* mapped = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, bytes, GL_MAP_READ_BIT)) {
        std::memcpy(pixels.data(), mapped, static_cast<std::size_t>(bytes));
        glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return unpack(pixels);
}

}  // namespace hitscope
