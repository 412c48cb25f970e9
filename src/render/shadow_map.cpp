// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shadow_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <string>
#include <utility>

#include "deform/cluster_reach.h"
#include "render/refined/moved_area.h"
#include "render/refined/varying_area.h"
#include "render/seen/drawn_bounds.h"
#include "render/seen/seen_area.h"
#include "render/target_pass.h"

namespace hitscope::render {
namespace {

constexpr int kSize = 2048;
constexpr float kShadowSpread = 1.6f;  // texels from one look to the next
constexpr float kLeastMargin = 0.05f;  // of the targets' extent
constexpr float kMostMargin = 1.6f;    // beyond, texels would be too coarse
constexpr float kDepthBias = 1.5f;     // texels

glm::vec3 directionOf(const Frame& frame) {
    const glm::vec3& given = frame.lights.directional.direction;
    return glm::length(given) > 1.0e-6f ? given : glm::vec3(0.0f, -1.0f, 0.0f);
}

/// From the world to the light's axes.
glm::mat4 lightView(const glm::vec3& given) {
    const glm::vec3 direction = glm::normalize(given);
    const glm::vec3 up =
        std::abs(direction.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    return glm::lookAt(glm::vec3(0.0f), direction, up);
}

void addSeen(Bounds& all, const glm::mat4& view, const Bounds& box) {
    if (!box.empty()) {
        for (const glm::vec3& corner : cornersOf(box)) {
            all.add(glm::vec3(view * glm::vec4(corner, 1.0f)));
        }
    }
}

/// The original shapes, in the light's axes.
Bounds originalsSeen(const Frame& frame, const glm::mat4& view) {
    Bounds seen;
    for (const DrawItem& item : frame.targets) {
        addSeen(seen, view, worldBounds(item));
    }
    if (seen.empty()) {
        seen.add(glm::vec3(0.0f));
    }
    return seen;
}

bool bulges(const Bounds& drawn, const Bounds& original) {
    return glm::any(glm::lessThan(drawn.min, original.min)) ||
           glm::any(glm::greaterThan(drawn.max, original.max));
}

float extentOf(const Bounds& seen) {
    return std::max({seen.size().x, seen.size().y, 1.0e-6f});
}

}  // namespace

float ShadowMap::marginOf(const Frame& frame, const DeformationPipeline& pipeline) {
    std::vector<std::pair<const DrawItem*, Bounds>> bulging;
    for (const DrawItem& item : frame.targets) {
        const std::optional<Bounds> drawn = probableBounds(item, frame, pipeline);
        if (drawn && !drawn->empty() && bulges(*drawn, item.buffers->originalBounds())) {
            bulging.emplace_back(&item, *drawn);
        }
    }
    if (bulging.empty()) {
        return kLeastMargin;
    }
    const glm::mat4 view = lightView(directionOf(frame));
    const Bounds original = originalsSeen(frame, view);
    Bounds seen = original;
    for (const auto& [item, drawn] : bulging) {
        addSeen(seen, view * item->model, drawn);
    }
    const glm::vec3 more = glm::max(original.min - seen.min, seen.max - original.max);
    const float wanted = std::max(more.x, more.y) / extentOf(original);
    // In steps, or each dent that bulges further would move all of the map's texels.
    float margin = kLeastMargin;
    while (margin < wanted && margin < kMostMargin) {
        margin *= 2.0f;
    }
    return margin;
}

ShadowMap::ShadowMap(bool software, Edges edges)
    : m_software(software), m_edges(edges), m_size(software ? kSoftwareSize : kSize) {}

std::vector<ShadowMap::Caster> ShadowMap::castersOf(const Frame& frame) {
    std::vector<Caster> casters;
    for (const DrawItem& item : frame.targets) {
        casters.push_back({item.target, item.buffers, item.model});
    }
    return casters;
}

bool ShadowMap::isWanted(const Frame& frame) {
    return frame.options.shadows && frame.lights.directional.on && !frame.targets.empty() &&
           frame.options.wireframe != WireframeMode::Only;
}

bool ShadowMap::make() {
    const bool isNew = !m_depth;
    if (isNew) {
        makeTexture();
    }
    return isNew;
}

void ShadowMap::makeTexture() {
    m_depth = gl::Texture::make();
    m_framebuffer = gl::Framebuffer::make();
    glBindTexture(GL_TEXTURE_2D, m_depth.id());
    const bool isSampled = m_software && m_edges == Edges::Sampled;
    // Many of these may be kept. Depths need not be finer than a texel is wide.
    glTexImage2D(GL_TEXTURE_2D, 0, isSampled ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24, m_size, m_size, 0,
                 GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
    // Samples have lights at other places, and so texels at others: where the CPU draws, one each will do.
    const GLint filter = isSampled ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const std::array<GLfloat, 4> lit{1.0f, 1.0f, 1.0f, 1.0f};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depth.id(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
}

glm::mat4 ShadowMap::place(const FrameContext& context) {
    const glm::mat4 view = lightView(m_direction);
    const Bounds seen = originalsSeen(context.frame, view);
    const float extent = extentOf(seen);
    const glm::vec3 grown(m_margin * extent);
    const glm::vec3 low = seen.min - grown;
    const glm::vec3 high = seen.max + grown;
    const glm::mat4 projection = glm::ortho(low.x, high.x, low.y, high.y, -high.z, -low.z);
    m_texel = (1.0f + 2.0f * m_margin) * extent / static_cast<float>(m_size);
    const float depthBias = kDepthBias * m_texel / (high.z - low.z);
    m_matrix = glm::translate(glm::mat4(1.0f), glm::vec3(0.5f, 0.5f, 0.5f - depthBias)) *
               glm::scale(glm::mat4(1.0f), glm::vec3(0.5f)) * projection * view;
    return projection * view;
}

ShadowMap::Change ShadowMap::changeSince(const FrameContext& context,
                                         const DeformationPipeline& pipeline) const {
    const Frame& frame = context.frame;
    const bool isOfThese = frame.meshRevision != 0 && m_pipeline == &pipeline &&
                           directionOf(frame) == m_direction && castersOf(frame) == m_casters &&
                           frame.options.beforeAfter.exaggeration == m_exaggeration;
    if (isOfThese && frame.meshRevision == m_meshRevision) {
        return Change::Nothing;
    }
    return isOfThese && marginOf(frame, pipeline) == m_margin ? Change::Vertices : Change::Anything;
}

void ShadowMap::follow(const FrameContext& context, const DeformationPipeline& pipeline) {
    const Frame& frame = context.frame;
    m_casters = castersOf(frame);
    m_direction = directionOf(frame);
    m_margin = marginOf(frame, pipeline);
    m_exaggeration = frame.options.beforeAfter.exaggeration;
    m_meshRevision = frame.meshRevision;
    m_pipeline = &pipeline;
    m_moments.clear();
    for (const DrawItem& item : frame.targets) {
        const ClusterReach* reach = pipeline.reach(item.target);
        m_moments.push_back(reach != nullptr ? reach->moment() : 0);
    }
}

double ShadowMap::shareOf(const MarkedTiles& texels) const {
    return static_cast<double>(texels.pixels()) / (1.0 * m_size * m_size);
}

std::optional<MarkedTiles> ShadowMap::movedTexels(const FrameContext& context,
                                                  const DeformationPipeline& pipeline,
                                                  const glm::mat4& toClip) const {
    const Frame& frame = context.frame;
    // Nobody knows where exaggerated vertices are.
    const bool isKnown = isWhole() || m_texels;
    if (!isKnown || m_exaggeration != 1.0f) {
        return std::nullopt;
    }
    std::vector<PixelArea> all = isWhole() ? std::vector<PixelArea>() : m_texels->rectangles();
    for (std::size_t i = 0; i < frame.targets.size(); ++i) {
        const DrawItem& item = frame.targets[i];
        const auto moved = movedTriangles(item, frame, pipeline, m_moments[i]);
        if (!moved) {
            return std::nullopt;
        }
        const glm::mat4 itemToClip = toClip * item.model;
        for (const Bounds& box : *moved) {
            SeenArea seen(itemToClip);
            if (!seen.add(box)) {
                return std::nullopt;
            }
            all.push_back(seen.in({m_size, m_size}));
        }
    }
    const MarkedTiles texels = MarkedTiles::around(all);
    return shareOf(texels) > 0.5 ? std::nullopt : std::optional(texels);
}

std::size_t ShadowMap::trianglesToDraw(const FrameContext& context, const DeformationPipeline& pipeline) {
    const Change change = changeSince(context, pipeline);
    if (change == Change::Nothing && isWhole()) {
        return 0;
    }
    if (change == Change::Vertices) {
        const glm::mat4 toClip = place(context);
        if (const std::optional<MarkedTiles> texels = movedTexels(context, pipeline, toClip)) {
            return trianglesWithin(context, pipeline, toClip, windowOf(texels->area(), glm::ivec2(m_size)),
                                   {&*texels, glm::ivec2(m_size)});
        }
    }
    return trianglesOf(context.frame);
}

/// Within an area there are about as many triangles as its share of the map, or twice as many.
std::uint32_t ShadowMap::partsToDraw(const FrameContext& context, std::uint32_t parts) const {
    if (context.frame.meshRevision == 0) {
        return 1;  // what is new each time is never whole in parts
    }
    if (!m_texels) {
        return parts;
    }
    return std::clamp(static_cast<std::uint32_t>(std::ceil(2.0 * shareOf(*m_texels) * parts)), 1u, parts);
}

Status ShadowMap::update(const FrameContext& context, DeformationPipeline& pipeline, std::uint32_t parts) {
    const Change change = changeSince(context, pipeline);
    if (change == Change::Nothing && isWhole()) {
        return Done{};
    }
    if (change != Change::Nothing) {
        m_texels = change == Change::Vertices ? movedTexels(context, pipeline, place(context)) : std::nullopt;
        follow(context, pipeline);
    }
    const std::uint32_t wanted = partsToDraw(context, parts);
    if (change != Change::Nothing || m_parts != wanted) {
        m_parts = wanted;
        m_drawn = m_texels && m_texels->pixels() == 0 ? wanted : 0;
    }
    return isWhole() ? Status(Done{}) : draw(context, pipeline);
}

void ShadowMap::clear() const {
    glClearDepth(1.0);
    if (!m_texels) {
        glClear(GL_DEPTH_BUFFER_BIT);
        return;
    }
    for (const PixelArea& rectangle : m_texels->rectangles()) {
        limitDrawing(rectangle);
        glClear(GL_DEPTH_BUFFER_BIT);
    }
}

Status ShadowMap::draw(const FrameContext& context, DeformationPipeline& pipeline) {
    const glm::mat4 toClip = place(context);
    if (!m_depth) {
        makeTexture();
        if (m_parts > 1) {
            return Done{};  // the next call draws the first part
        }
    }
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glViewport(0, 0, m_size, m_size);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glEnable(GL_DEPTH_CLAMP);  // what bulges towards the light casts a shadow from wherever it is
    if (m_drawn == 0) {
        clear();
    }
    std::optional<PictureWindow> window;
    if (m_texels) {
        limitDrawing(m_texels->area());
        window = windowOf(m_texels->area(), glm::ivec2(m_size));
    }
    FrameContext part = context;
    part.part = {m_drawn, m_parts};
    const TilesOfPicture tiles{m_texels ? &*m_texels : nullptr, glm::ivec2(m_size)};
    Status status = drawSurfaceDepth(part, pipeline, toClip, DepthOf::Whole, 0.0f, window, tiles);
    m_drawn += status ? 1 : 0;
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_CLAMP);
    return status;
}

gl::Defines ShadowMap::defines() const {
    const char* taps = m_edges == Edges::Sampled ? "1" : m_software ? "4" : "9";
    return {{"HITSCOPE_SHADOWS", "1"}, {"HITSCOPE_SHADOW_TAPS", taps}};
}

void ShadowMap::apply(const gl::Program& program) const {
    program.set("u_shadowMap", 1);
    program.set("u_shadowSpread", kShadowSpread / static_cast<float>(m_size));
    program.set("u_shadowMatrix", m_matrix);
    program.set("u_shadowTexel", m_texel);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, m_depth.id());
    glBindSampler(1, 0);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace hitscope::render
