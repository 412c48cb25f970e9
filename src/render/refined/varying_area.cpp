// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/refined/varying_area.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "render/seen/seen_area.h"
#include "render/shadow_map.h"

namespace hitscope::render {

namespace {

constexpr float kLowestLight = 0.1f;      // sine of its height; shadows of lower lights reach far
constexpr float kNearlyWhole = 0.85f;     // of the picture
constexpr std::size_t kMostBoxes = 2048;  // that are looked at: a millisecond

/// What is drawn over surfaces, or somewhere else than the pipeline says.
bool isBeyondTargets(const Frame& frame) {
    const DisplayOptions& options = frame.options;
    return !frame.projectiles.empty() || frame.section != nullptr || options.needles || options.dots ||
           options.wireframe == WireframeMode::Only || options.beforeAfter.wipe ||
           options.beforeAfter.ghost != GhostMode::Off;
}

/// Of a part of a target; false: what it reaches may be anywhere.
bool seePart(SeenArea& seen, const Bounds& box, const FrameContext& context, float lightRadius, float texel) {
    if (!seen.add(grown(box, occlusionReach(context.frame)))) {
        return false;
    }
    if (!ShadowMap::isWanted(context.frame) || !context.frame.options.floor) {
        return true;
    }
    const std::optional<Bounds> shadow = floorShadowOf(box, context.frame, lightRadius, texel);
    return shadow && seen.add(*shadow);
}

bool seeTargets(SeenArea& seen, const FrameContext& context, const DeformationPipeline& pipeline,
                float lightRadius) {
    const Frame& frame = context.frame;
    const float texel = shadowTexel(frame, pipeline);
    for (const DrawItem& item : frame.targets) {
        const std::optional<ClusterBoxes> boxes = clusterBoxesOf(item, frame, pipeline);
        if (!boxes) {
            return false;
        }
        for (const Bounds& box : boxes->ofGroups(kMostBoxes)) {
            if (!box.empty() && !seePart(seen, inWorld(box, item), context, lightRadius, texel)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

Bounds grown(const Bounds& box, float by) {
    return {box.min - glm::vec3(by), box.max + glm::vec3(by)};
}

Bounds inWorld(const Bounds& box, const DrawItem& item) {
    Bounds result;
    for (const glm::vec3& corner : cornersOf(box)) {
        result.add(glm::vec3(item.model * glm::vec4(corner, 1.0f)));
    }
    return result;
}

float shadowTexel(const Frame& frame, const DeformationPipeline& pipeline) {
    Bounds all;
    for (const DrawItem& item : frame.targets) {
        all.add(worldBounds(item));
    }
    const float reach = 1.0f + 2.0f * ShadowMap::marginOf(frame, pipeline);
    return reach * all.diagonal() / static_cast<float>(ShadowMap::kSoftwareSize);
}

std::optional<Bounds> floorShadowOf(const Bounds& box, const Frame& frame, float lightRadius, float texel) {
    const glm::vec3& given = frame.lights.directional.direction;
    const float length = glm::length(given);
    if (!(length > 1.0e-6f) || !(-given.y > kLowestLight * length)) {
        return std::nullopt;
    }
    const glm::vec3 down = given / -given.y;
    const float floor = frame.floorHeight;
    Bounds shadow;
    float highest = 0.0f;
    for (const glm::vec3& corner : cornersOf(box)) {
        const float height = std::max(corner.y - floor, 0.0f);
        highest = std::max(highest, height);
        const glm::vec3 at = corner + height * down;
        shadow.add({at.x, floor, at.z});
    }
    // The light's edge is lightRadius off for each metre along its way, which the floor cuts aslant.
    const float way = highest * glm::length(down);
    const glm::vec3 more(way * lightRadius * 2.0f * glm::length(down) + kShadowTexels * texel);
    return Bounds{shadow.min - glm::vec3(more.x, 0.0f, more.z), shadow.max + glm::vec3(more.x, 0.0f, more.z)};
}

void limitDrawing(const PixelArea& area) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x, area.y, area.width, area.height);
}

void limitDrawing(const DrawnPixels& pixels) {
    limitDrawing(pixels.area);
    if (pixels.marked) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, 1, 1);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }
}

PixelArea varyingArea(const FrameContext& context, const DeformationPipeline& pipeline, float lightRadius) {
    const glm::ivec2 picture(context.frame.width, context.frame.height);
    const PixelArea whole{0, 0, picture.x, picture.y};
    SeenArea seen(context.steadyViewProjection);
    if (isBeyondTargets(context.frame) || !seeTargets(seen, context, pipeline, lightRadius)) {
        return whole;
    }
    const PixelArea area = seen.in(picture);
    const double share = (1.0 * area.width * area.height) / (1.0 * picture.x * picture.y);
    return share > kNearlyWhole ? whole : area;
}

}  // namespace hitscope::render
