// SPDX-License-Identifier: GPL-3.0-or-later
// Which pixels of a refined picture need more samples, and what none of them shows.
#include <cstdint>
#include <utility>
#include <vector>

#include "render/refined/refined_picture.h"
#include "render/refined/varying_area.h"
#include "render/seen/seen_area.h"

namespace hitscope {

const render::FrontDepths* RefinedPicture::frontOfParts(const render::FrameContext& context,
                                                        GLuint framebuffer,
                                                        const render::DrawnPixels* within) {
    if (context.part.index < context.part.count / 2) {
        m_frontOfParts.reset();
        return nullptr;
    }
    if (!m_frontOfParts) {
        const PixelArea whole{0, 0, m_width, m_height};
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        m_frontOfParts = render::FrontDepths::ofBound(
            context.frame.left, within != nullptr ? intersected(within->area, whole) : whole);
    }
    return &*m_frontOfParts;
}

void RefinedPicture::readWhatIsDue() {
    if (std::exchange(m_isFrontDue, false)) {
        readFront();
    }
    if (std::exchange(m_areMarksDue, false)) {
        readMarks();
    }
}

void RefinedPicture::readFront() {
    glBindFramebuffer(GL_FRAMEBUFFER, m_plain.id());
    m_front = render::FrontDepths::ofBound(0, {0, 0, m_width, m_height}, render::kSampleReach);
}

Status RefinedPicture::settle(render::ProgramCache& programs, GLuint emptyArray) {
    const auto found = programs.get("refined.vert", "unsettled.frag");
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    glBindFramebuffer(GL_FRAMEBUFFER, m_sample.id());
    glDisable(GL_BLEND);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(1);
    glClearStencil(0);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilFunc(GL_ALWAYS, 1, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    program.use();
    program.set("u_sum", 0);
    program.set("u_share", 1.0f / static_cast<float>(m_samples));
    const glm::ivec2 first(m_area.x, m_area.y);
    const glm::ivec2 size(m_area.width, m_area.height);
    program.set("u_first", glm::vec2(first));
    program.set("u_last", glm::vec2(first + size - 1));
    glBindTexture(GL_TEXTURE_2D, m_sum.id());
    glBindVertexArray(emptyArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    m_areMarksDue = true;
    return Done{};
}

void RefinedPicture::readMarks() {
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(m_area.width) *
                                    static_cast<std::size_t>(m_area.height));
    glBindFramebuffer(GL_FRAMEBUFFER, m_sample.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(m_area.x, m_area.y, m_area.width, m_area.height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE,
                 marks.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    m_unsettled.emplace(m_area, marks);
    // From now on they are counted.
    glBindFramebuffer(GL_FRAMEBUFFER, m_adding.id());
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glClearColor(0.0f, 0.0f, 0.0f, static_cast<float>(m_samples));
    glClear(GL_COLOR_BUFFER_BIT);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace hitscope
