// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The inside of Renderer: for renderer.cpp, which draws frames, and renderer_refine.cpp, which draws samples.
#include <deque>
#include <optional>

#include "gl/context.h"
#include "gl/fence.h"
#include "render/change_map.h"
#include "render/dent_ghost_pass.h"
#include "render/frame_context.h"
#include "render/gl_state.h"
#include "render/line_pass.h"
#include "render/original_shape.h"
#include "render/projectile_pass.h"
#include "render/refined/refined_picture.h"
#include "render/refined/varying_area.h"
#include "render/section_pass.h"
#include "render/shadow_map.h"
#include "render/studio.h"
#include "render/trail_pass.h"
#include "view/environment.h"

namespace hitscope {

namespace render {

/// The frame with the lights that it is lit by.
class LitFrame {
public:
    explicit LitFrame(const Frame& given) : m_given(given) {
        if (given.options.environment) {
            m_lit = given;
            m_lit->lights = environmentLights();
        }
    }
    [[nodiscard]] const Frame& frame() const { return m_lit ? *m_lit : m_given; }

private:
    const Frame& m_given;
    std::optional<Frame> m_lit;
};

/// What is in a framebuffer that is drawn to.
enum class Before { Goes, Stays };
/// within: null: the whole viewport.
void prepareFramebuffer(const Frame& frame, GLuint framebuffer, const DrawnPixels* within = nullptr,
                        Before before = Before::Goes);
void startSolid();
void startBlended();
/// Marks are on what they mark: left of a wipe's line on the originals.
[[nodiscard]] Status drawMarks(const FrameContext& context, DeformationPipeline& pipeline);

}  // namespace render

struct Renderer::Private {
    render::ProgramCache programs;
    render::ColourTextures colourTextures;
    render::ProjectilePass projectiles;
    render::NeedlePass needles;
    render::TrailPass trails;
    render::DentGhostPass dentGhost;
    render::SectionPass sections;
    gl::VertexArray emptyArray = gl::VertexArray::make();
    bool wasCoarse = false;  ///< at the last draw()
    bool software = gl::rendererInfo().isSoftware();
    render::ShadowMap shadows{software};
    render::ShadowMap coarseShadows{software};  ///< of coarse frames, where the other is not up to date
    /// Of samples, so that the other one is there when something moves. By RefinedPicture::LightPlace::index:
    /// those of a place that is looked from again are kept while the camera alone moves. The last is of all
    /// other places.
    std::vector<render::ShadowMap> sampleShadows;
    // Left of a wipe's line: of a frame, of a coarse one, and of a sample.
    render::OriginalShape originalShape;
    render::ShadowMap originalShadows{software};
    render::ShadowMap originalCoarseShadows{software};
    render::ShadowMap originalSampleShadows{software, render::ShadowMap::Edges::Sampled};
    gl::Sampler sampleTextures;  ///< made with the first sample that needs it
    render::Studio studio;
    // Of the sample at hand; none: the picture is drawn as it is.
    glm::vec2 jitter{0.0f};
    const render::Occlusion* occlusion = nullptr;
    std::deque<gl::Fence> refining;  ///< after the last calls of refine(), where the CPU draws

    Private() = default;
    Private(const Private&) = delete;
    Private& operator=(const Private&) = delete;

    [[nodiscard]] render::ShadowMap& shadowsFor(const render::FrameContext& context,
                                                const DeformationPipeline& pipeline);
    /// The frame's own, where it has shadows.
    [[nodiscard]] Status updateShadows(render::FrameContext& context, DeformationPipeline& pipeline);
    [[nodiscard]] render::ShadowMap& sampleShadowsAt(int place);
    /// The one that goes with a map of what is drawn now.
    [[nodiscard]] render::ShadowMap& originalShadowsFor(const render::ShadowMap& map);
    [[nodiscard]] Status updateOriginalShadows(const render::FrameContext& context);
    [[nodiscard]] render::FrameContext contextOf(const Frame& frame);
    /// Targets and projectiles into a framebuffer, what is selected as well; nothing over them. In parts, the
    /// framebuffer keeps what the ones before have drawn.
    [[nodiscard]] Status drawPicture(const render::FrameContext& context, DeformationPipeline& pipeline,
                                     GLuint framebuffer, const render::DrawnPixels* within = nullptr);
    /// The same of few triangles, and what is drawn over them, in one pixel.
    [[nodiscard]] Status drawFew(render::FrameContext& context, DeformationPipeline& pipeline,
                                 GLuint framebuffer);
    /// What is drawn over everything.
    [[nodiscard]] Status drawOver(const render::FrameContext& context);
    /// The next part of a picture that is refined: context.part.count is set, and the index will be.
    [[nodiscard]] Status drawPart(render::FrameContext& context, DeformationPipeline& pipeline,
                                  RefinedPicture& picture, GLuint framebuffer,
                                  const render::DrawnPixels* within = nullptr);
    /// The picture as draw() draws it, or the next part of it.
    [[nodiscard]] Status drawPlain(render::FrameContext& context, DeformationPipeline& pipeline,
                                   RefinedPicture& picture);
    /// What has to be known before the first sample: that picture, and then what samples have in common.
    [[nodiscard]] Status begin(render::FrameContext& context, DeformationPipeline& pipeline,
                               RefinedPicture& picture);
    [[nodiscard]] Status drawSample(render::FrameContext& context, DeformationPipeline& pipeline,
                                    RefinedPicture& picture);
    [[nodiscard]] Status addSample(const Frame& frame, DeformationPipeline& pipeline,
                                   RefinedPicture& picture);
    [[nodiscard]] Status drawGhosts(const Frame& frame, DeformationPipeline& pipeline);
    /// Targets and what marks them.
    [[nodiscard]] Status drawScene(const render::FrameContext& context, DeformationPipeline& pipeline);
    [[nodiscard]] Status drawWiped(const render::FrameContext& context, DeformationPipeline& pipeline);
    Status drawDotsAndNeedles(const render::FrameContext& context, DeformationPipeline& pipeline);
};

}  // namespace hitscope
