// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/line_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

#include "render/change_map.h"
#include "render/cut_away.h"
#include "render/early_start.h"
#include "render/seen/visible_runs.h"

namespace hitscope::render {
namespace {

constexpr float kLineWidth = 1.2f;    // logical pixels
constexpr float kNeedleWidth = 1.2f;  // logical pixels
constexpr float kLinesAhead = 2.0f;   // pixels' size at their distance: lines lie before the faces they bound
constexpr float kWideFrom = 6.0f;     // logical pixels of an edge, below which a width cannot be seen
constexpr float kSmallPixels = 1.5f;  // to a logical one
constexpr float kNeedlesApart = 12.0f;                                // logical pixels
constexpr float kNeedleLength = 0.8f;                                 // of the way from one to the next
constexpr std::uint32_t kMostNeedles = 20000;                         // of a target
constexpr std::uint32_t kLongestStep = 2048 / sizeof(DynamicVertex);  // as far apart as attributes may lie
constexpr float kDot = 3.6f;                                          // logical pixels across
constexpr glm::vec2 kDotsApart(11.0f, 20.0f);  // logical pixels: dots start to show, show in full

/// Logical pixels that a metre takes at this distance.
float pixelsAt(const FrameContext& context, float distance) {
    return context.pixelsAt(std::max(distance, 1.0e-7f)) / context.frame.pixelRatio;
}

float depthShift(const FrameContext& context) {
    return context.depthPerPixel * kLinesAhead;
}

void setWideLine(const gl::Program& program, const FrameContext& context, float width) {
    const float half = 0.5f * width * context.frame.pixelRatio;
    program.set("u_halfSize", 0.5f * glm::vec2(context.frame.width, context.frame.height));
    program.set("u_halfWidth", half);
    program.set("u_reach", half + 1.0f);
}

/// On the filling of a cut nothing of the inside is seen.
void addFilling(gl::Defines& defines, const Frame& frame) {
    if (isCutFilled(frame)) {
        defines.emplace_back("HITSCOPE_CUT_FILLED", "1");
    }
}

void setPlace(const gl::Program& program, const FrameContext& context) {
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_depthShift", depthShift(context));
    setDrawnPlace(program, context.frame);
    if (isCutFilled(context.frame)) {
        setCutFill(program, context.frame);
    }
}

void setEdgePixels(const gl::Program& program, const FrameContext& context, const DrawItem& item) {
    program.set("u_edgePixels", item.buffers->usualEdge() * pixelsAt(context, 1.0f));
}

Result<const gl::Program*> edgeProgram(const FrameContext& context, const DeformationPipeline& pipeline,
                                       bool wide, bool ghost) {
    gl::Defines defines = ghost ? pipeline.drawDefines() : targetDefines(context.frame, pipeline);
    if (!ghost) {
        addFilling(defines, context.frame);
    } else {
        const gl::Defines cut = cutDefines(context.frame);
        defines.insert(defines.end(), cut.begin(), cut.end());
        defines.emplace_back("HITSCOPE_GHOST", "1");
    }
    if (wide) {
        defines.emplace_back("HITSCOPE_WIDE", "1");
    }
    return context.programs.get("wire.vert", "wire.frag", defines, wide ? "wire.geom" : "");
}

/// A little beyond the picture's edges for the lines' width.
PictureWindow linesWindow(const FrameContext& context) {
    constexpr glm::vec2 kReach(1.05f);
    return context.window.value_or(PictureWindow{-kReach, kReach});
}

/// Lines cost so much that culling the hidden ones pays.
bool isInPicture(const FrameContext& context, const DeformationPipeline& pipeline, const DrawItem& item) {
    return mayShow(item, context.frame, pipeline, context.viewProjection, linesWindow(context));
}

std::size_t drawRuns(const IndexRuns& runs) {
    glMultiDrawElements(GL_LINES, runs.counts.data(), GL_UNSIGNED_INT, runs.starts.data(),
                        static_cast<GLsizei>(runs.counts.size()));
    return runs.indices;
}

/// Returns how many indices it drew. From close by, much of a target lies beside the picture.
std::size_t drawLines(const FrameContext& context, const DeformationPipeline& pipeline, const DrawItem& item,
                      bool ghost) {
    if (ghost && item.changedParts != nullptr) {
        return drawRuns(item.changedParts->edges());
    }
    if (const auto runs =
            visibleEdges(item, context.frame, pipeline, context.viewProjection, linesWindow(context))) {
        return drawRuns(*runs);
    }
    glDrawElements(GL_LINES, static_cast<GLsizei>(item.buffers->edgeIndexCount()), GL_UNSIGNED_INT, nullptr);
    return item.buffers->edgeIndexCount();
}

/// Logical pixels of edges that are drawn as wide lines, and longer ones.
float wideFrom(const FrameContext& context, const EdgeStyle& style) {
    return style.faint && context.frame.pixelRatio < kSmallPixels ? std::numeric_limits<float>::infinity()
                                                                  : kWideFrom;
}

Status drawEdgesOf(const FrameContext& context, DeformationPipeline& pipeline, const EdgeStyle& style,
                   bool wide) {
    const ClipByCut clip(context.frame);
    const gl::Program* program = nullptr;
    const glm::vec4 selected(glm::mix(glm::vec3(style.colour), context.colours.accent, style.selectionTint),
                             style.colour.a);
    EarlyStart earlyStart(context);
    for (const DrawItem& item : context.frame.targets) {
        const float pixels = nearestEdgePixels(context, item);
        if (pixels < style.leastPixels || (pixels >= wideFrom(context, style)) != wide ||
            !isInPicture(context, pipeline, item)) {
            continue;
        }
        if (program == nullptr) {
            const auto found = edgeProgram(context, pipeline, wide, style.ghost);
            if (!found) {
                return found.error();
            }
            program = found.value();
            program->use();
            setPlace(*program, context);
            setWideLine(*program, context, kLineWidth);
            program->set("u_fade", glm::vec3(style.fade.from, style.fade.to, style.fade.least));
        }
        pipeline.prepareDraw(*program, item.target);
        program->set("u_model", item.model);
        program->set("u_colour", item.selected ? selected : style.colour);
        setEdgePixels(*program, context, item);
        glBindVertexArray(item.original && !style.ghost ? item.buffers->originalEdgeArray()
                                                        : item.buffers->edgeArray());
        earlyStart.drawn(drawLines(context, pipeline, item, style.ghost));
    }
    return Done{};
}

const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): GL's way to say it
}

/// One needle for so many vertices: neighbours in the buffer are neighbours in space.
std::uint32_t needleStep(const FrameContext& context, const DrawItem& item) {
    const float distance = glm::distance(context.eye, worldBounds(item).centre());
    const float pixels = std::max(item.buffers->usualEdge() * pixelsAt(context, distance), 1.0e-3f);
    const float apart = kNeedlesApart / pixels;
    const auto byPicture = static_cast<std::uint32_t>(std::clamp(apart * apart, 1.0f, 1.0e6f));
    const std::uint32_t byCount = (item.buffers->drawnVertexCount() + kMostNeedles - 1) / kMostNeedles;
    return std::min(std::max(byPicture, byCount), kLongestStep);
}

/// Every `step`th vertex is an instance.
void attachNeedles(const TargetBuffers& buffers, std::uint32_t step) {
    const auto attach = [step](Attribute attribute, GLuint buffer, std::size_t size, std::size_t offset) {
        const auto index = static_cast<GLuint>(attribute);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(step * size),
                              bufferOffset(offset));
        glVertexAttribDivisor(index, 1);
    };
    attach(Attribute::Position, buffers.dynamicBuffer(), sizeof(DynamicVertex),
           offsetof(DynamicVertex, position));
    attach(Attribute::Normal, buffers.dynamicBuffer(), sizeof(DynamicVertex),
           offsetof(DynamicVertex, normal));
    attach(Attribute::OriginalPosition, buffers.originalBuffer(), sizeof(DynamicVertex),
           offsetof(DynamicVertex, position));
    attach(Attribute::ShadingNormal, buffers.shadingNormalBuffer(), sizeof(glm::vec3), 0);
}

/// A vertex array keeps the buffers of a target in memory that is gone.
void detachNeedles() {
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    for (const Attribute attribute :
         {Attribute::Position, Attribute::Normal, Attribute::OriginalPosition, Attribute::ShadingNormal}) {
        glDisableVertexAttribArray(static_cast<GLuint>(attribute));
        glVertexAttribPointer(static_cast<GLuint>(attribute), 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
}

}  // namespace

float nearestEdgePixels(const FrameContext& context, const DrawItem& item) {
    const Bounds bounds = worldBounds(item);
    const glm::vec3 nearest = glm::clamp(context.eye, bounds.min, bounds.max);
    return item.buffers->usualEdge() * pixelsAt(context, glm::distance(context.eye, nearest));
}

Status drawEdges(const FrameContext& context, DeformationPipeline& pipeline, const EdgeStyle& style) {
    if (Status status = drawEdgesOf(context, pipeline, style, false); !status) {
        return status;
    }
    return drawEdgesOf(context, pipeline, style, true);
}

Status drawDots(const FrameContext& context, DeformationPipeline& pipeline) {
    const ClipByCut clip(context.frame);
    const gl::Program* program = nullptr;
    for (const DrawItem& item : context.frame.targets) {
        if (nearestEdgePixels(context, item) < kDotsApart.x) {
            continue;
        }
        if (program == nullptr) {
            gl::Defines defines = targetDefines(context.frame, pipeline);
            addFilling(defines, context.frame);
            const auto found = context.programs.get("dots.vert", "dots.frag", defines);
            if (!found) {
                return found.error();
            }
            program = found.value();
            program->use();
            setPlace(*program, context);
            program->set("u_pixels", kDot * context.frame.pixelRatio);
            program->set("u_apart", kDotsApart);
            program->set("u_colour", context.colours.dots);
            glEnable(GL_PROGRAM_POINT_SIZE);
        }
        pipeline.prepareDraw(*program, item.target);
        program->set("u_model", item.model);
        setEdgePixels(*program, context, item);
        glBindVertexArray(item.buffers->surfaceArray());
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(item.buffers->drawnVertexCount()));
    }
    return Done{};
}

Status NeedlePass::draw(const FrameContext& context, DeformationPipeline& pipeline) {
    gl::Defines defines = targetDefines(context.frame, pipeline);
    defines.emplace_back("HITSCOPE_WIDE", "1");
    if (context.frame.options.normals == NormalMode::Paper) {
        defines.emplace_back("HITSCOPE_PAPER_NORMALS", "1");
    }
    const auto found = context.programs.get("needle.vert", "wire.frag", defines);
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    setPlace(program, context);
    setWideLine(program, context, kNeedleWidth);
    const ClipByCut clip(context.frame);
    program.set("u_colour", context.colours.needles);
    glBindVertexArray(m_array.id());
    for (const DrawItem& item : context.frame.targets) {
        const std::uint32_t step = needleStep(context, item);
        const std::uint32_t count = (item.buffers->drawnVertexCount() + step - 1) / step;
        if (count == 0) {
            continue;
        }
        pipeline.prepareDraw(program, item.target);
        program.set("u_model", item.model);
        program.set("u_length",
                    kNeedleLength * item.buffers->usualEdge() * std::sqrt(static_cast<float>(step)));
        attachNeedles(*item.buffers, step);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
    }
    detachNeedles();
    return Done{};
}

}  // namespace hitscope::render
