// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/frame_context.h"
#include "render/refined/marked_tiles.h"

namespace hitscope::render {

/// What the directional light sees first: a depth map around the visible targets, drawn with their pipeline's
/// own program and kept until a target, its mesh or the light has changed. Where only vertices have moved,
/// the part that these were and are seen in is drawn anew. Coarse frames and others have each a map of their
/// own, but those that are up to date are good for both. A context is current for every call and the
/// destructor.
class ShadowMap {
public:
    static constexpr int kSoftwareSize = 1024;  ///< texels, where the CPU draws

    /// Sampled: the shadow is one of many of a light at other places, whose mean is soft.
    enum class Edges { Soft, Sampled };
    explicit ShadowMap(bool software, Edges edges = Edges::Soft);

    /// Whether a frame has shadows.
    [[nodiscard]] static bool isWanted(const Frame& frame);
    /// How far the map of a frame reaches beyond the original shapes, in their extent: in steps, from 0.05
    /// on, as what is drawn bulges.
    [[nodiscard]] static float marginOf(const Frame& frame, const DeformationPipeline& pipeline);
    /// Brings the map up to date, or on by one of so many parts. Leaves framebuffer and viewport changed,
    /// depth test and writes on.
    [[nodiscard]] Status update(const FrameContext& context, DeformationPipeline& pipeline,
                                std::uint32_t parts = 1);
    /// Makes its texture, which takes a software renderer about as long as drawing it; false: it was there.
    bool make();
    /// Whether the frame needs nothing drawn.
    [[nodiscard]] bool isUpToDate(const FrameContext& context, const DeformationPipeline& pipeline) const {
        return isWhole() && changeSince(context, pipeline) == Change::Nothing;
    }
    /// How many triangles update() would draw.
    [[nodiscard]] std::size_t trianglesToDraw(const FrameContext& context,
                                              const DeformationPipeline& pipeline);
    /// Whether it is up to date since the last call; it is after one of one part.
    [[nodiscard]] bool isWhole() const { return m_drawn == m_parts; }

    /// What programs that read it are built with.
    [[nodiscard]] gl::Defines defines() const;
    /// Sets the uniforms of shadow.glsl and binds the map to unit 1; the program is in use.
    void apply(const gl::Program& program) const;
    /// From the world to the map's texture coordinates and depth, [0, 1] each.
    [[nodiscard]] const glm::mat4& matrix() const { return m_matrix; }
    [[nodiscard]] Edges edges() const { return m_edges; }
    [[nodiscard]] float margin() const { return m_margin; }  ///< marginOf() the frame that it was drawn for
    /// Of the light that it was drawn for.
    [[nodiscard]] const glm::vec3& direction() const { return m_direction; }
    /// Metres.
    [[nodiscard]] float texel() const { return m_texel; }

private:
    struct Caster {
        TargetId target;
        const TargetBuffers* buffers = nullptr;
        glm::mat4 model{1.0f};
        bool operator==(const Caster&) const = default;
    };
    [[nodiscard]] static std::vector<Caster> castersOf(const Frame& frame);
    /// What has changed since the map was drawn.
    enum class Change : std::uint8_t { Nothing, Vertices, Anything };
    void makeTexture();
    [[nodiscard]] std::uint32_t partsToDraw(const FrameContext& context, std::uint32_t parts) const;
    [[nodiscard]] Change changeSince(const FrameContext& context, const DeformationPipeline& pipeline) const;
    /// Takes what the map is of from the frame.
    void follow(const FrameContext& context, const DeformationPipeline& pipeline);
    /// Returns the light's view and projection.
    glm::mat4 place(const FrameContext& context);
    /// Texels in which moved vertices were and are seen, and those that were still to be drawn; nothing: they
    /// are not known, or most of the map.
    [[nodiscard]] std::optional<MarkedTiles> movedTexels(const FrameContext& context,
                                                         const DeformationPipeline& pipeline,
                                                         const glm::mat4& toClip) const;
    [[nodiscard]] double shareOf(const MarkedTiles& texels) const;
    /// What is drawn, of what is bound. Leaves the scissor test on.
    void clear() const;
    /// The next of the parts.
    [[nodiscard]] Status draw(const FrameContext& context, DeformationPipeline& pipeline);

    bool m_software;
    Edges m_edges;
    int m_size;  ///< texels
    gl::Texture m_depth;
    gl::Framebuffer m_framebuffer;
    glm::mat4 m_matrix{1.0f};
    float m_texel = 0.0f;
    std::vector<Caster> m_casters;         ///< of the map as it is
    std::vector<std::uint64_t> m_moments;  ///< of these, at which the map shows them (ClusterReach)
    glm::vec3 m_direction{0.0f};
    float m_exaggeration = 1.0f;
    float m_margin = 0.0f;  ///< marginOf()
    std::uint64_t m_meshRevision = 0;
    /// That are drawn; nothing: all. All others hold the nearest depths, which drawing a triangle that has
    /// not moved again leaves as they are.
    std::optional<MarkedTiles> m_texels;
    std::uint32_t m_parts = 1;  ///< that they are drawn in
    std::uint32_t m_drawn = 0;  ///< of these
    const DeformationPipeline* m_pipeline = nullptr;
};

}  // namespace hitscope::render
