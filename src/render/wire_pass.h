// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/frame_context.h"

namespace hitscope::render {

// Wireframes without surfaces.

/// What hides lines behind it, and nothing to be seen of it; but targets whose edges are too short for lines
/// to be told apart are filled as their lines would fill them, premultiplied by the opacity. The
/// framebuffer's colour and opacity are 0 where nothing has been drawn.
[[nodiscard]] Status drawWireSurfaces(const FrameContext& context, DeformationPipeline& pipeline);
/// The lines, those behind surfaces dimmed. Blending is on, depth test GL_LESS, depth writes off.
[[nodiscard]] Status drawWireLines(const FrameContext& context, DeformationPipeline& pipeline);

}  // namespace hitscope::render
