// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/ghost_pass.h"

#include "render/early_start.h"
#include "render/line_pass.h"

namespace hitscope::render {

namespace {

constexpr float kWireOpacity = 0.55f;

Status drawTranslucent(const FrameContext& originals) {
    const auto found = originals.programs.get("surface.vert", "ghost.frag");
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    program.set("u_viewProjection", originals.viewProjection);
    program.set("u_eye", originals.eye);
    program.set("u_colour", originals.colours.accent);
    EarlyStart earlyStart(originals);
    for (const DrawItem& item : originals.frame.targets) {
        program.set("u_model", item.model);
        glBindVertexArray(item.buffers->originalSurfaceArray());
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(item.buffers->triangleIndexCount()),
                       GL_UNSIGNED_INT, nullptr);
        earlyStart.drawn(item.buffers->vertexCount());
    }
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
        return drawTranslucent(originals);
    }
    return drawEdges(originals, pipeline,
                     {glm::vec4(originals.colours.accent, kWireOpacity), 0.0f, 0.0f, true});
}

}  // namespace hitscope::render
