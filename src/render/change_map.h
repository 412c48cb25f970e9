// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "render/frame_context.h"
#include "render/renderer.h"

namespace hitscope::render {

/// Colour maps as textures, each made when it is first wanted. A context is current for every call and the
/// destructor.
class ColourTextures {
public:
    [[nodiscard]] GLuint get(ColourMap map);

private:
    std::array<gl::Texture, kColourMaps> m_textures;
};

/// What programs that draw targets are built with: the pipeline's definitions and what change.glsl and
/// cut.glsl want.
[[nodiscard]] gl::Defines targetDefines(const Frame& frame, const DeformationPipeline& pipeline);
/// Likewise for what a cutting plane leaves whole.
[[nodiscard]] gl::Defines wholeTargetDefines(const Frame& frame, const DeformationPipeline& pipeline);
/// Sets the uniforms of both of a program built with them, in use. Passes that draw where targets are need
/// no more.
void setDrawnPlace(const gl::Program& program, const Frame& frame);
/// Sets the uniforms of a program built with HITSCOPE_CHANGE_MAP and binds the colours to a texture unit of
/// their own; frame.change is there.
void setChangeMap(const gl::Program& program, const FrameContext& context);

}  // namespace hitscope::render
