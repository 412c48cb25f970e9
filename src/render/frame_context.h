// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>

#include "gl/objects.h"
#include "render/program_cache.h"
#include "render/renderer.h"
#include "render/seen/drawn_bounds.h"
#include "view/theme.h"

namespace hitscope::render {

class ColourTextures;
class FrontDepths;
class MarkedTiles;
class ShadowMap;
class Studio;

/// How samples of a refined picture know what is close by: occlusion.glsl.
struct Occlusion {
    GLuint depths = 0;       ///< a texture: the depths of the same picture, with no jitter
    glm::vec2 jitter{0.0f};  ///< of this sample, pixels
    glm::vec2 turn{0.0f};    ///< [0, 1): places that it looks at
};

/// How samples of a refined picture know what the floor looks like: drawFloorLayer()'s pictures.
struct FloorLayers {
    GLuint lit = 0;     ///< a texture: with no shadows
    GLuint shaded = 0;  ///< likewise, in the shadow of the directional light everywhere
};

/// A picture that is drawn in parts, between which others may draw: of the surfaces' triangles each has its
/// share; the first has what is drawn before them too, the last what is drawn after them.
struct SurfacePart {
    std::uint32_t index = 0;
    std::uint32_t count = 1;

    [[nodiscard]] bool isFirst() const { return index == 0; }
    [[nodiscard]] bool isLast() const { return index + 1 == count; }
    /// The share of a range.
    [[nodiscard]] DrawRange of(const DrawRange& range) const {
        const std::uint64_t triangles = range.count / 3;
        const auto begin = static_cast<std::uint32_t>(3 * (triangles * index / count));
        const auto end = static_cast<std::uint32_t>(3 * (triangles * (index + 1) / count));
        return {range.first + begin, end - begin, range.material};
    }
};

/// What every pass of a frame needs. The references live as long as the frame.
struct FrameContext {
    const Frame& frame;
    const ThemeColours& colours;
    ProgramCache& programs;
    ColourTextures& colourTextures;
    bool software = false;       ///< the CPU draws
    bool* drewCoarse = nullptr;  ///< set where a coarse shape is drawn; may be null
    GLuint emptyArray = 0;       ///< a vertex array without attributes, for corners made in the shader
    glm::mat4 projection{1.0f};
    glm::mat4 viewProjection{1.0f};
    glm::mat4 steadyViewProjection{1.0f};  ///< the same in each sample of a refined picture
    glm::vec3 eye{0.0f};
    glm::vec3 forward{0.0f};
    const ShadowMap* shadows = nullptr;        ///< null: none
    const Occlusion* occlusion = nullptr;      ///< null: nothing keeps light away
    const FloorLayers* floorLayers = nullptr;  ///< null: the floor is drawn as it is
    GLuint textureSampler = 0;                 ///< of materials' textures; 0: each has its own
    const Studio* studio = nullptr;            ///< null: neither environment nor matcap
    float pixelsAtOneMetre = 1.0f;  ///< how many pixels a metre takes, a metre from the eye; or anywhere,
                                    ///< orthographic
    /// Added to clip.z it brings something nearer by the size that a pixel has there, to first order.
    /// Perspective: clip.z = A d + B and clip.w = d at a distance d, so depth is A + B / d; b B on top is as
    /// a distance of (1 - b) d. Orthographic: clip.z = -A d + B and clip.w = 1.
    float depthPerPixel = 0.0f;

    SurfacePart part = {};                     ///< of the picture, what is drawn
    const MarkedTiles* tiles = nullptr;        ///< nothing of surfaces is wanted elsewhere; null: everywhere
    const FrontDepths* front = nullptr;        ///< surfaces behind these are not wanted; null: all are
    std::optional<PictureWindow> window = {};  ///< nothing else of the picture can be drawn to

    /// False: nothing of the target can be drawn within the window.
    [[nodiscard]] bool mayShow(const DrawItem& item, const DeformationPipeline& pipeline) const {
        return !window || render::mayShow(item, frame, pipeline, viewProjection, *window);
    }

    /// How many pixels a metre takes at a distance (> 0) from the eye.
    [[nodiscard]] float pixelsAt(float distance) const {
        return frame.camera.isOrthographic() ? pixelsAtOneMetre : pixelsAtOneMetre / distance;
    }
};

/// Of the original shape, in the world; empty for a mesh without vertices.
[[nodiscard]] Bounds worldBounds(const DrawItem& item);

/// The way that the camera looks, in the target's local frame.
[[nodiscard]] glm::vec3 alongView(const FrameContext& context, const DrawItem& item);

/// Which lights are on, for programs that include lighting.glsl.
[[nodiscard]] gl::Defines lightDefines(const Lights& lights);
/// Writes the uniforms of lighting.glsl in a program built with lightDefines(); it is in use.
void setLights(const gl::Program& program, const FrameContext& context);

/// For programs that include sight.glsl.
void addSight(gl::Defines& defines, const Frame& frame);
/// Writes its uniform in a program built with that; it is in use.
void setSight(const gl::Program& program, const Frame& frame);

/// What programs that include occlusion.glsl are built with; empty without context.occlusion. They need
/// addSight(), too.
[[nodiscard]] gl::Defines occlusionDefines(const FrameContext& context);
/// Writes its uniforms; the program is in use. offset: of what is drawn, pixels.
void setOcclusion(const gl::Program& program, const FrameContext& context, const glm::vec2& offset);
/// How far away something can be to keep light away, metres.
[[nodiscard]] float occlusionReach(const Frame& frame);

// Each draws one thing with blending, and expects depth test on and depth writes off.
[[nodiscard]] Status drawBackground(const FrameContext& context);
[[nodiscard]] Status drawFloor(const FrameContext& context);
/// How much of the light around arrives at the floor, into a picture of `size` pixels of the same view; there
/// is context.occlusion. With neither blending nor depths, like the next.
[[nodiscard]] Status drawFloorOpen(const FrameContext& context, const glm::ivec2& size);
/// The floor's colours and opacity. open: a texture, what drawFloorOpen() drew; 0: nothing keeps light away.
[[nodiscard]] Status drawFloorLayer(const FrameContext& context, bool isShaded, GLuint open);
[[nodiscard]] Status drawContactShades(const FrameContext& context);
enum class MarkPlaces { Drawn, Original };
/// Dots on vertices, where they are drawn or where they were; dimmed where a surface hides them.
[[nodiscard]] Status drawVertexMarks(const FrameContext& context, DeformationPipeline& pipeline,
                                     MarkPlaces places = MarkPlaces::Drawn);
[[nodiscard]] Status drawHighlightedHit(const FrameContext& context);
[[nodiscard]] Status drawCrosshair(const FrameContext& context);

}  // namespace hitscope::render
