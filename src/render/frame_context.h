// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "gl/objects.h"
#include "render/program_cache.h"
#include "render/renderer.h"
#include "render/theme.h"

namespace hitscope::render {

/// What every pass of a frame needs. The references live as long as the frame.
struct FrameContext {
    const Frame& frame;
    const ThemeColours& colours;
    ProgramCache& programs;
    bool software = false;  ///< the CPU draws
    GLuint emptyArray = 0;  ///< a vertex array without attributes, for corners made in the shader
    glm::mat4 projection{1.0f};
    glm::mat4 viewProjection{1.0f};
    glm::vec3 eye{0.0f};
    glm::vec3 forward{0.0f};
    float pixelsAtOneMetre = 1.0f;  ///< how many pixels a metre takes, a metre from the eye
};

/// Writes the uniforms of lighting.glsl; the program is in use.
void setLights(const gl::Program& program, const FrameContext& context);

// Each draws one thing with blending, and expects depth test on and depth writes off.
[[nodiscard]] Status drawBackground(const FrameContext& context);
[[nodiscard]] Status drawFloor(const FrameContext& context);
[[nodiscard]] Status drawContactShades(const FrameContext& context);
/// Dots on vertices; dimmed where a surface hides them.
[[nodiscard]] Status drawVertexMarks(const FrameContext& context, DeformationPipeline& pipeline);
[[nodiscard]] Status drawHighlightedHit(const FrameContext& context);
[[nodiscard]] Status drawCrosshair(const FrameContext& context);

}  // namespace hitscope::render
