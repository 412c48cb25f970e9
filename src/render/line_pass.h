// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/frame_context.h"

namespace hitscope::render {

/// Logical pixels: shorter edges only darken or fill a surface, and are not drawn as lines.
inline constexpr float kLeastEdge = 2.0f;

/// Lines that lie closely fade, so that they do not fill the surface with one colour: from full opacity where
/// edges take `to` logical pixels to `least` of it where they take `from`.
struct EdgeFade {
    float from = 0.5f;
    float to = 9.0f;
    float least = 0.15f;
};
/// Over a surface, where they come and go with the distance and must not do so at once.
inline constexpr EdgeFade kFadeOverSurface{kLeastEdge, 6.5f, 0.0f};

struct EdgeStyle {
    glm::vec4 colour{1.0f};      ///< sRGB, opacity
    float selectionTint = 0.0f;  ///< [0, 1]: how much of the accent colour a selected target's edges take on
    float leastPixels = 0.0f;    ///< shorter edges than these (logical pixels) are not worth drawing
    EdgeFade fade = {};
    bool ghost = false;  ///< where the target was, and only edges that moved
    bool faint = false;  ///< hardly seen: lines of a pixel do, unless pixels are small
};

/// Logical pixels of a usual edge of the target, where it is nearest to the eye.
[[nodiscard]] float nearestEdgePixels(const FrameContext& context, const DrawItem& item);

// Each expects blending on, depth test on and depth writes off.
/// The edges of the file's polygons, as lines of constant width; short ones as plain lines of a pixel.
[[nodiscard]] Status drawEdges(const FrameContext& context, DeformationPipeline& pipeline,
                               const EdgeStyle& style);
/// The vertices, where a usual edge is long enough to part them.
[[nodiscard]] Status drawDots(const FrameContext& context, DeformationPipeline& pipeline);

/// Normals as needles, as many as can be told apart. A context is current for every call and the destructor.
class NeedlePass {
public:
    [[nodiscard]] Status draw(const FrameContext& context, DeformationPipeline& pipeline);

private:
    gl::VertexArray m_array = gl::VertexArray::make();
};

}  // namespace hitscope::render
