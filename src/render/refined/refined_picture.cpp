// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/refined/refined_picture.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "render/refined/varying_area.h"

namespace hitscope {
namespace {

gl::Texture makeTexture(GLint format, GLenum pixels, GLenum type, int width, int height,
                        GLint filter = GL_NEAREST) {
    gl::Texture texture = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, pixels, type, nullptr);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_2D, name, filter);
    }
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
    }
    return texture;
}

gl::Texture makeDepths(int width, int height) {
    return makeTexture(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, width, height);
}

/// depthTexture: of makeDepths(); 0 for none.
gl::Framebuffer makeFramebuffer(GLuint colour, GLuint depthTexture) {
    gl::Framebuffer framebuffer = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour, 0);
    if (depthTexture != 0) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depthTexture, 0);
    }
    return framebuffer;
}

void bind(int unit, const gl::Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindSampler(static_cast<GLuint>(unit), 0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

bool isComplete(const gl::Framebuffer& framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

void RefinedPicture::clear() {
    m_hasPlain = false;
    m_taken = {};
    m_rough = {};
    m_roughParts.clear();
    m_unrefined.reset();
    forgetSamples();
}

void RefinedPicture::forgetSamples() {
    m_samples = 0;
    m_kept = 0;
    m_isBegun = false;
    m_front.reset();
    m_unsettled.reset();
    m_isFrontDue = false;
    m_areMarksDue = false;
    m_nextPart = 0;
}

void RefinedPicture::plainDrawn(std::vector<std::uint64_t> moments, float shadowMargin) {
    m_shadowMargin = shadowMargin;
    m_hasPlain = true;
    m_nextPart = 0;
    m_rough = {};
    m_roughParts.clear();
    m_moments = std::move(moments);
}

Status RefinedPicture::keepMean(render::ProgramCache& programs, GLuint emptyArray) {
    if (m_samples < kJudged || m_kept == m_samples) {
        return Done{};
    }
    m_kept = m_samples;
    glBindFramebuffer(GL_FRAMEBUFFER, m_plain.id());
    glViewport(0, 0, m_width, m_height);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    Status drawn = drawOne(programs, emptyArray, true, false);
    m_taken = united(m_taken, m_area);
    return drawn;
}

Status RefinedPicture::takeFromSample(render::ProgramCache& programs, GLuint emptyArray,
                                      std::span<const PixelArea> parts) {
    const auto found = programs.get("refined.vert", "refined.frag", {{"HITSCOPE_DEPTHS", "1"}});
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    glBindFramebuffer(GL_FRAMEBUFFER, m_plain.id());
    glViewport(0, 0, m_width, m_height);
    glDisable(GL_BLEND);
    // Depths are written only where the test is on.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    program.use();
    program.set("u_picture", 0);
    program.set("u_depths", 1);
    program.set("u_share", 1.0f);
    bind(1, m_sampleDepth);
    bind(0, m_sampleColour);
    glBindVertexArray(emptyArray);
    for (const PixelArea& part : parts) {
        render::limitDrawing(part);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDisable(GL_SCISSOR_TEST);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    return Done{};
}

void RefinedPicture::clearForPatch(const PicturePatch& patch) const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_plain.id());
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glStencilMask(0xFF);  // zink loses what is cleared through a mask of some bits
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepth(1.0);
    glClearStencil(0);
    render::limitDrawing(patch.area);
    glClear(GL_STENCIL_BUFFER_BIT);
    glClearStencil(1);
    for (const PixelArea& part : patch.parts) {
        render::limitDrawing(part);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
}

void RefinedPicture::patched(const PicturePatch& patch, std::vector<std::uint64_t> moments) {
    m_rough = patch.isCoarse ? patch.area : PixelArea();
    m_roughParts = patch.isCoarse ? patch.parts : std::vector<PixelArea>();
    if (m_samples >= kUsualSamples) {
        m_unrefined = PixelArea();
    }
    if (m_unrefined && patch.refined) {
        m_unrefined = united(*m_unrefined, united(*patch.refined, patch.area));
    } else {
        m_unrefined.reset();
    }
    m_moments = std::move(moments);
    forgetSamples();
}

void RefinedPicture::begin(const PixelArea& varying, bool maySettle) {
    m_settles = maySettle && m_extent == Extent::WhereItStillVaries;
    const PixelArea whole{0, 0, m_width, m_height};
    m_area = m_extent == Extent::Everywhere ? whole : united(varying, m_taken);
    m_shown = m_area;
    if (m_unrefined) {
        m_shown = intersected(intersected(m_area, *m_unrefined), whole);
        m_shown = m_shown.empty() ? PixelArea{0, 0, 1, 1} : m_shown;
        // Which pixels settle depends on their neighbours.
        m_area = intersected(united(intersected(m_area, widened(*m_unrefined, 1)), m_shown), whole);
    }
    m_isBegun = true;
    m_isFrontDue = m_settles;
}

std::optional<PixelArea> RefinedPicture::partToDraw() const {
    if (!m_rough.empty()) {
        return m_rough;
    }
    return m_isBegun && m_unrefined ? std::optional(m_area) : std::nullopt;
}

void RefinedPicture::makePart(int part, const glm::ivec2& size) {
    const auto colours = [&size] { return makeTexture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, size.x, size.y); };
    switch (part) {
        case 0:
            m_colour = colours();
            m_depths = makeDepths(size.x, size.y);
            break;
        case 1:
            m_sum = makeTexture(GL_RGBA32F, GL_RGBA, GL_FLOAT, size.x, size.y);
            m_sampleColour = colours();
            break;
        case 2: {
            for (gl::Texture& floor : m_floor) {
                floor = colours();
            }
            const glm::ivec2 open = floorOpenSize(size.x, size.y);
            m_floorOpen = makeTexture(GL_R8, GL_RED, GL_UNSIGNED_BYTE, open.x, open.y, GL_LINEAR);
            break;
        }
        default:
            m_sampleDepth = makeDepths(size.x, size.y);
            break;
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

bool RefinedPicture::makeFramebuffers() {
    m_plain = makeFramebuffer(m_colour.id(), m_depths.id());
    m_sample = makeFramebuffer(m_sampleColour.id(), m_sampleDepth.id());
    m_adding = makeFramebuffer(m_sum.id(), m_sampleDepth.id());
    for (std::size_t i = 0; i < m_floor.size(); ++i) {
        m_drawnFloor[i] = makeFramebuffer(m_floor[i].id(), 0);
    }
    m_drawnFloorOpen = makeFramebuffer(m_floorOpen.id(), 0);
    return isComplete(m_plain) && isComplete(m_sample) && isComplete(m_adding) &&
           isComplete(m_drawnFloor[0]) && isComplete(m_drawnFloor[1]) && isComplete(m_drawnFloorOpen);
}

RefinedPicture::Made RefinedPicture::prepare(int width, int height, bool inParts) {
    constexpr int kParts = 4;
    constexpr int kLarge = 256 * 1024;  // pixels: fewer take some milliseconds
    if (width == m_width && height == m_height) {
        return Made::All;
    }
    if (m_coming != glm::ivec2(width, height)) {
        clear();
        m_width = 0;
        m_height = 0;
        m_coming = {width, height};
        m_madeParts = 0;
    }
    const bool isAtOnce = !inParts || width * height < kLarge;
    do {
        makePart(m_madeParts++, m_coming);
    } while (isAtOnce && m_madeParts < kParts);
    if (m_madeParts < kParts) {
        return Made::Part;
    }
    m_coming = {0, 0};
    if (!makeFramebuffers()) {
        return Made::None;
    }
    m_width = width;
    m_height = height;
    return Made::All;
}

Status RefinedPicture::add(render::ProgramCache& programs, GLuint emptyArray) {
    gl::Defines defines;
    if (m_settles) {
        defines.emplace_back(m_unsettled ? "HITSCOPE_COUNT" : "HITSCOPE_SQUARES", "1");
    }
    const auto found = programs.get("refined.vert", "refined.frag", defines);
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    glBindFramebuffer(GL_FRAMEBUFFER, m_adding.id());
    glViewport(0, 0, m_width, m_height);
    render::limitDrawing(drawnPixels());
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
    glBindTexture(GL_TEXTURE_2D, m_sampleColour.id());
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, 0);
    ++m_samples;
    return m_settles && m_samples == kJudged ? settle(programs, emptyArray) : Status(Done{});
}

gl::Defines RefinedPicture::drawDefines(bool isSum, bool withDepths) const {
    gl::Defines defines;
    if (withDepths) {
        defines.emplace_back("HITSCOPE_DEPTHS", "1");
    }
    if (isSum && m_settles) {
        defines.emplace_back(m_unsettled ? "HITSCOPE_COUNTED" : "HITSCOPE_OPAQUE", "1");
    }
    return defines;
}

Status RefinedPicture::drawOne(render::ProgramCache& programs, GLuint emptyArray, bool isSum,
                               bool withDepths) const {
    const auto found = programs.get("refined.vert", "refined.frag", drawDefines(isSum, withDepths));
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_picture", 0);
    program.set("u_depths", 1);
    program.set("u_share", isSum ? 1.0f / static_cast<float>(m_samples) : 1.0f);
    bind(1, m_depths);
    bind(0, isSum ? m_sum : m_colour);
    if (isSum) {
        render::limitDrawing(m_shown);
    }
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
    return Done{};
}

Status RefinedPicture::draw(render::ProgramCache& programs, GLuint emptyArray, bool withDepths,
                            int fewest) const {
    glDisable(GL_BLEND);
    // Depths are written only where the test is on.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(withDepths ? GL_TRUE : GL_FALSE);
    Status drawn = drawOne(programs, emptyArray, false, withDepths);
    glDepthMask(GL_FALSE);
    if (drawn && !isPlainShown(fewest)) {
        drawn = drawOne(programs, emptyArray, true, false);
    }
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    return drawn;
}

}  // namespace hitscope
