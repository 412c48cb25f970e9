// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "gl/objects.h"
#include "render/frame_context.h"
#include "render/pixel_area.h"
#include "render/program_cache.h"
#include "render/refined/marked_tiles.h"
#include "render/refined/varying_area.h"
#include "render/seen/front_depths.h"

namespace hitscope {

/// The mean of many pictures of one frame, which differ by fractions of a pixel, by where on the light a
/// shadow is cast from, and by where they look for what keeps light away: smooth edges, soft shadows, ambient
/// occlusion. Renderer::refine() adds to it; where all samples are alike, it has the picture as it is. A
/// context is current for every call and the destructor.
class RefinedPicture {
public:
    static constexpr int kUsualSamples = 16;  ///< of a window's picture
    static constexpr int kMostSamples = 64;

    /// Where samples are drawn. Everywhere: where they are alike too, to see that they are; it takes longer.
    /// WhereItVaries: but for where nothing can make them differ. WhereItStillVaries: where the CPU draws,
    /// only the first ones; all others at pixels alone in which these, or neighbours, differ by as much as
    /// one would see.
    enum class Extent { WhereItStillVaries, WhereItVaries, Everywhere };
    static constexpr int kJudged = 4;  ///< the first samples, which tell where others are drawn
    /// Samples are drawn in parts of so many triangles.
    static constexpr std::size_t kUsualPart = 1 << 15;  ///< some ten milliseconds of a software renderer
    explicit RefinedPicture(Extent extent = Extent::WhereItVaries, std::size_t trianglesAPart = kUsualPart)
        : m_extent(extent), m_trianglesAPart(trianglesAPart) {}

    /// What one sample differs by from the others.
    struct Sample {
        glm::vec2 jitter{0.0f};  ///< pixels, half of one at most, and a little
        glm::vec2 light{0.0f};   ///< on the light, in the unit disc
        glm::vec2 turn{0.0f};    ///< as in Occlusion
    };
    /// index >= 0. Any number of the first ones are spread evenly.
    [[nodiscard]] static Sample sampleAt(int index);

    /// How many samples it is the mean of.
    [[nodiscard]] int samples() const { return m_samples; }
    /// Whether there is anything to draw: a sample, or what has to be known before the first one, which is a
    /// picture too.
    [[nodiscard]] bool hasPicture() const { return m_hasPlain; }
    /// Forgets the picture, keeps its buffers.
    void clear();
    /// Where it has fewer triangles since it was patched, until the first sample is drawn.
    [[nodiscard]] const PixelArea& rough() const { return m_rough; }
    /// Of that, just where; they do not overlap.
    [[nodiscard]] std::span<const PixelArea> roughParts() const { return m_roughParts; }

    // What follows is the Renderer's.

    /// How many of the buffers exist. None: the driver has no room for them.
    enum class Made { None, Part, All };
    /// Makes buffers of that size, pixels, where they have another one. inParts: each call makes some of
    /// them if they are large, since a software renderer clears them.
    [[nodiscard]] Made prepare(int width, int height, bool inParts = false);
    /// The frame without jitter has been drawn into plainFramebuffer(), with the targets at these moments of
    /// theirs (DrawItem::settled).
    void plainDrawn(std::vector<std::uint64_t> moments, float shadowMargin);
    [[nodiscard]] std::span<const std::uint64_t> moments() const { return m_moments; }
    [[nodiscard]] float shadowMargin() const { return m_shadowMargin; }
    /// Where there are samples enough, the plain picture becomes their mean: showing it again takes half the
    /// time, and what is patched stays as it was shown. Leaves framebuffer, viewport and blending changed.
    [[nodiscard]] Status keepMean(render::ProgramCache& programs, GLuint emptyArray);
    /// Whether draw() would draw the plain picture: there are fewer samples, or it is their mean.
    [[nodiscard]] bool isPlainShown(int fewest) const { return m_samples < fewest || m_kept == m_samples; }
    /// Marks these parts of it in the stencil buffer of plainFramebuffer(), where nothing is in front of what
    /// is drawn from then on. Leaves framebuffer, scissor test and masks changed.
    void clearForPatch(const PicturePatch& patch) const;
    /// These parts of what is in sampleFramebuffer() become the plain picture's. Leaves framebuffer,
    /// viewport, scissor and depth test changed.
    [[nodiscard]] Status takeFromSample(render::ProgramCache& programs, GLuint emptyArray,
                                        std::span<const PixelArea> parts);
    /// A part of the plain picture was drawn again: there are no samples, and the picture has the targets at
    /// these moments. Where it was refined in full before, only what differs is refined again.
    void patched(const PicturePatch& patch, std::vector<std::uint64_t> moments);
    /// Whether begin() was called.
    [[nodiscard]] bool isBegun() const { return m_isBegun; }
    /// Samples follow the plain picture; they differ within `varying`. maySettle: the CPU draws, and the
    /// picture is opaque.
    void begin(const PixelArea& varying, bool maySettle);
    /// Whether something has to be read back before the next sample: who does not want to wait for that gives
    /// the GPU time first.
    [[nodiscard]] bool isReadingDue() const { return m_isFrontDue || m_areMarksDue; }
    /// Reads it. Leaves framebuffer and masks changed.
    void readWhatIsDue();
    /// Samples are drawn within it.
    [[nodiscard]] const PixelArea& area() const { return m_area; }
    /// Where something is drawn next, if that is known to be a part of the picture alone.
    [[nodiscard]] std::optional<PixelArea> partToDraw() const;
    /// Where on the light a sample's shadows are cast from.
    struct LightPlace {
        glm::vec2 at;  ///< in the unit disc
        int index =
            0;  ///< the same place has the same one in every picture; kKept and more: of this one only
        static constexpr int kKept = 10;  ///< of usual pictures in a window, where the CPU draws
    };
    /// Of the next one. software: neighbours share a place, since a shadow map takes the CPU as long as a
    /// third of a sample.
    [[nodiscard]] LightPlace nextLight(bool software) const;
    /// Where the next one is drawn.
    [[nodiscard]] render::DrawnPixels drawnPixels() const { return {m_area, m_unsettled.has_value()}; }
    /// Likewise; null: everywhere.
    [[nodiscard]] const render::MarkedTiles* unsettled() const {
        return m_unsettled ? &*m_unsettled : nullptr;
    }
    /// What is behind these is hidden in every sample; null: that is not known.
    [[nodiscard]] const render::FrontDepths* front() const { return m_front ? &*m_front : nullptr; }
    [[nodiscard]] GLuint depths() const { return m_depths.id(); }  ///< a texture
    [[nodiscard]] GLuint plainFramebuffer() const { return m_plain.id(); }
    [[nodiscard]] render::FloorLayers floorLayers() const { return {m_floor[0].id(), m_floor[1].id()}; }
    /// Of these, what is drawn into.
    [[nodiscard]] GLuint floorFramebuffer(bool isShaded) const { return m_drawnFloor[isShaded ? 1 : 0].id(); }
    /// How much light arrives at the floor: a texture of fewer pixels, and what is drawn into.
    static constexpr int kFloorOpenStep = 3;  ///< the picture's pixels in each of its own, each way
    [[nodiscard]] GLuint floorOpen() const { return m_floorOpen.id(); }
    [[nodiscard]] GLuint floorOpenFramebuffer() const { return m_drawnFloorOpen.id(); }
    [[nodiscard]] glm::ivec2 floorOpenSize() const { return floorOpenSize(m_width, m_height); }
    [[nodiscard]] GLuint sampleFramebuffer() const { return m_sample.id(); }
    [[nodiscard]] std::size_t trianglesAPart() const { return m_trianglesAPart; }
    /// The part that is drawn next of what is drawn in parts.
    [[nodiscard]] std::uint32_t nextPart() const { return m_nextPart; }
    /// What the next part may be hidden by, of what was drawn into the framebuffer before; null: nothing. It
    /// is looked at once, when half of the parts are there. Leaves the framebuffer changed.
    [[nodiscard]] const render::FrontDepths* frontOfParts(const render::FrameContext& context,
                                                          GLuint framebuffer,
                                                          const render::DrawnPixels* within);
    /// Of so many; all have as many, wherever triangles are meanwhile.
    [[nodiscard]] std::uint32_t parts() const { return m_parts; }
    void setNextPart(std::uint32_t part, std::uint32_t of) {
        m_nextPart = part;
        m_parts = of;
    }
    /// readWhatIsDue() was called. Adds what is in sampleFramebuffer() to the sum. Leaves framebuffer,
    /// viewport and blending changed.
    [[nodiscard]] Status add(render::ProgramCache& programs, GLuint emptyArray);
    /// Draws the mean, or the plain picture where there are fewer than `fewest` samples (1 or more), over the
    /// whole viewport of what is bound, and the depths where they are wanted. Leaves depth test and blending
    /// off.
    [[nodiscard]] Status draw(render::ProgramCache& programs, GLuint emptyArray, bool withDepths,
                              int fewest) const;

private:
    void makePart(int part, const glm::ivec2& size);
    [[nodiscard]] bool makeFramebuffers();
    [[nodiscard]] static glm::ivec2 floorOpenSize(int width, int height) {
        return (glm::ivec2(width, height) + kFloorOpenStep - 1) / kFloorOpenStep;
    }
    void readFront();
    void readMarks();
    /// Marks what is drawn from now on in the stencil buffer of samples.
    [[nodiscard]] Status settle(render::ProgramCache& programs, GLuint emptyArray);
    [[nodiscard]] gl::Defines drawDefines(bool isSum, bool withDepths) const;
    void forgetSamples();
    /// The sum, or the plain picture.
    [[nodiscard]] Status drawOne(render::ProgramCache& programs, GLuint emptyArray, bool isSum,
                                 bool withDepths) const;

    int m_width = 0;  ///< of all buffers; 0: they are not all there
    int m_height = 0;
    glm::ivec2 m_coming{0};  ///< of those that are being made
    int m_madeParts = 0;     ///< of these
    int m_samples = 0;
    Extent m_extent;
    std::size_t m_trianglesAPart;
    PixelArea m_area;
    PixelArea m_shown;  ///< of it: what samples are added up for
    PixelArea m_taken;  ///< outside of it, the plain picture was never a mean of samples
    int m_kept = 0;     ///< samples that it is the mean of
    PixelArea m_rough;
    std::vector<PixelArea> m_roughParts;
    std::optional<PixelArea> m_unrefined;  ///< elsewhere the plain picture is refined; nothing: nowhere
    std::vector<std::uint64_t> m_moments;  ///< of the plain picture
    float m_shadowMargin = 0.0f;           ///< likewise
    bool m_hasPlain = false;
    bool m_isBegun = false;
    bool m_settles = false;                      ///< some pixels after the first samples
    bool m_isFrontDue = false;                   ///< m_front is to be read
    bool m_areMarksDue = false;                  ///< m_unsettled is
    std::optional<render::FrontDepths> m_front;  ///< where pixels settle
    std::optional<render::MarkedTiles> m_unsettled;
    std::optional<render::FrontDepths> m_frontOfParts;
    std::uint32_t m_nextPart = 0;
    std::uint32_t m_parts = 1;
    gl::Texture m_colour;  ///< of the plain picture
    gl::Texture m_depths;
    gl::Texture m_sampleColour;          ///< of the sample at hand, within the area
    std::array<gl::Texture, 2> m_floor;  ///< lit, shaded
    gl::Texture m_floorOpen;
    /// Of floats, within the area. In place of opacity, if pixels settle: of the first samples the squares of
    /// their brightness, afterwards how many samples there are of each pixel.
    gl::Texture m_sum;
    gl::Texture m_sampleDepth;  ///< and stencil
    gl::Framebuffer m_plain;
    gl::Framebuffer m_sample;
    std::array<gl::Framebuffer, 2> m_drawnFloor;
    gl::Framebuffer m_drawnFloorOpen;
    gl::Framebuffer m_adding;
};

}  // namespace hitscope
