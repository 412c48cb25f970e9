// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/ghost_pass.h"

#include <limits>

#include "render/bounded_draw.h"
#include "render/cut_away.h"
#include "render/early_start.h"
#include "render/line_pass.h"

namespace hitscope::render {

namespace {

constexpr float kWireOpacity = 0.55f;
constexpr float kDenseOpacity = 0.6f;  // of wires that cannot be told apart, of that of a translucent surface

constexpr float kBehind = 1.0f;  // glPolygonOffset's units: the least there is

/// Returns how many indices it drew.
std::size_t drawChanged(const DrawItem& item) {
    if (item.changedParts != nullptr) {
        return drawRuns(GL_TRIANGLES, item.changedParts->triangles());
    }
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(item.buffers->triangleIndexCount()), GL_UNSIGNED_INT,
                   nullptr);
    return item.buffers->triangleIndexCount();
}

/// Targets whose edges are shorter than `belowEdge` (logical pixels).
Status drawTranslucent(const FrameContext& originals, float belowEdge, float opacity) {
    gl::Defines defines = cutDefines(originals.frame);
    addSight(defines, originals.frame);
    const auto found = originals.programs.get("surface.vert", "ghost.frag", defines);
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_viewProjection", originals.viewProjection);
    program.set("u_eye", originals.eye);
    setSight(program, originals.frame);
    program.set("u_colour", glm::vec4(originals.colours.accent, opacity));
    setCut(program, originals.frame);
    const ClipByCut clip(originals.frame);
    // Where nothing is displaced any more it lies in the surface, and not every renderer calculates the same
    // depths in two programs.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, kBehind);
    EarlyStart earlyStart(originals);
    for (const DrawItem& item : originals.frame.targets) {
        if (nearestEdgePixels(originals, item) >= belowEdge) {
            continue;
        }
        program.set("u_model", item.model);
        glBindVertexArray(item.buffers->originalSurfaceArray());
        earlyStart.drawn(drawChanged(item) / kIndicesPerVertex);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    return Done{};
}

}  // namespace

OriginalFrame::OriginalFrame(const Frame& changed)
    : items(changed.targets.begin(), changed.targets.end()), frame(changed) {
    for (DrawItem& item : items) {
        item.original = true;
    }
    frame.targets = items;
    frame.change.reset();
    frame.options.beforeAfter = {};
}

Status drawGhosts(const FrameContext& originals, DeformationPipeline& pipeline, GhostMode mode) {
    if (mode == GhostMode::Translucent) {
        return drawTranslucent(originals, std::numeric_limits<float>::infinity(), 1.0f);
    }
    if (Status status = drawTranslucent(originals, kLeastEdge, kDenseOpacity); !status) {
        return status;
    }
    return drawEdges(originals, pipeline,
                     {.colour = glm::vec4(originals.colours.accent, kWireOpacity),
                      .leastPixels = kLeastEdge,
                      .ghost = true});
}

}  // namespace hitscope::render
