// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that pictures will need, built one at a time before the first of these pictures.
#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "render/renderer_private.h"

namespace hitscope {

using namespace render;

namespace {

constexpr std::uint32_t kFewTriangles = 16;  // of each target: a driver may compile only what it draws with

/// A frame with what may come with the next ones, in front of the camera.
struct FullFrame {
    explicit FullFrame(const Frame& given) : frame(given) {
        const glm::vec3 at = given.camera.eye() + given.camera.forward() * given.camera.distance();
        const float size = 0.01f * given.camera.distance();
        trail = {at - glm::vec3(3.0f * size, 0.0f, 0.0f), at - glm::vec3(size, 0.0f, 0.0f)};
        projectiles[0].sphere = {at, size};
        projectiles[0].trail = trail;
        frame.projectiles = projectiles;
        frame.ghost = std::make_shared<const std::vector<glm::vec3>>(
            std::vector<glm::vec3>{at, at + glm::vec3(size, 0.0f, 0.0f), at + glm::vec3(0.0f, size, 0.0f)});
        frame.options.crosshair = true;
    }
    FullFrame(const FullFrame&) = delete;
    FullFrame& operator=(const FullFrame&) = delete;

    std::array<glm::vec3, 2> trail{};
    std::array<ProjectileItem, 1> projectiles;
    Frame frame;
};

std::uint32_t partsOfFewTriangles(const Frame& frame) {
    std::size_t most = 0;
    for (const DrawItem& item : frame.targets) {
        for (const DrawRange& range : drawsOf(item, frame.coarse)) {
            most = std::max(most, std::size_t{range.count} / 3);
        }
    }
    return static_cast<std::uint32_t>(std::max<std::size_t>(2, most / kFewTriangles));
}

}  // namespace

/// Into one pixel: the programs are what takes the time.
Status Renderer::Private::drawFew(FrameContext& context, DeformationPipeline& pipeline, GLuint framebuffer) {
    const DrawnPixels pixel{PixelArea{0, 0, 1, 1}, false};
    const std::uint32_t parts = partsOfFewTriangles(context.frame);
    for (const std::uint32_t part : {std::uint32_t{0}, parts - 1}) {
        context.part = {part, parts};
        if (Status status = drawPicture(context, pipeline, framebuffer, &pixel); !status) {
            return status;
        }
    }
    limitDrawing(pixel);
    if (Status status = drawMarks(context, pipeline); !status) {
        return status;
    }
    limitDrawing(pixel);
    if (Status status = trails.draw(context); !status) {
        return status;
    }
    return drawOver(context);
}

bool Renderer::warmUp(const Frame& given, DeformationPipeline& pipeline, GLuint framebuffer) {
    if (given.width <= 0 || given.height <= 0) {
        return true;
    }
    const KeepState keep;
    const FullFrame full(given);
    const LitFrame lit(full.frame);
    FrameContext context = d->contextOf(lit.frame());
    if (ShadowMap::isWanted(lit.frame())) {
        ShadowMap& map = d->shadowsFor(context, pipeline);
        if (map.make()) {
            return false;
        }
        context.shadows = &map;
    }
    d->programs.limitBuilding(1);
    static_cast<void>(d->drawFew(context, pipeline, framebuffer));  // what fails does so in a picture too
    const bool isAll = !d->programs.hasRefused();
    d->programs.limitBuilding({});
    return isAll;
}

}  // namespace hitscope
