// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/change_map.h"

#include <algorithm>

#include "render/cut_away.h"

namespace hitscope::render {

namespace {

constexpr int kUnit = 3;               // textures of materials have the first
constexpr float kIsolineWidth = 1.3f;  // logical pixels

}  // namespace

GLuint ColourTextures::get(ColourMap map) {
    gl::Texture& texture = m_textures[static_cast<std::size_t>(map)];
    if (!texture) {
        const ColourTable& table = colourTable(map);
        texture = gl::Texture::make();
        glBindTexture(GL_TEXTURE_2D, texture.id());
        GLint alignment = 4;
        glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, static_cast<GLsizei>(table.size()), 1, 0, GL_RGB,
                     GL_UNSIGNED_BYTE, table.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    return texture.id();
}

gl::Defines wholeTargetDefines(const Frame& frame, const DeformationPipeline& pipeline) {
    gl::Defines defines = pipeline.drawDefines();
    if (frame.options.beforeAfter.exaggeration != 1.0f) {
        defines.emplace_back("HITSCOPE_EXAGGERATED", "1");
    }
    return defines;
}

gl::Defines targetDefines(const Frame& frame, const DeformationPipeline& pipeline) {
    gl::Defines defines = wholeTargetDefines(frame, pipeline);
    const gl::Defines cut = cutDefines(frame);
    defines.insert(defines.end(), cut.begin(), cut.end());
    return defines;
}

void setDrawnPlace(const gl::Program& program, const Frame& frame) {
    program.set("u_exaggeration", frame.options.beforeAfter.exaggeration);
    setCut(program, frame);
}

void setChangeMap(const gl::Program& program, const FrameContext& context) {
    const ShownChange& change = *context.frame.change;
    program.set("u_changeQuantity", static_cast<int>(change.quantity));
    program.set("u_changeRange", glm::vec2(change.range.low, change.range.high));
    program.set("u_isolineStep", change.isolineStep);
    program.set("u_isolineWidth", std::max(1.0f, kIsolineWidth * context.frame.pixelRatio));
    program.set("u_changeColours", kUnit);
    glActiveTexture(GL_TEXTURE0 + kUnit);
    glBindSampler(kUnit, 0);
    glBindTexture(GL_TEXTURE_2D, context.colourTextures.get(change.map));
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace hitscope::render
