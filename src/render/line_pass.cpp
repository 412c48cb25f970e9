// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/line_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

#include "render/bounded_draw.h"
#include "render/change_map.h"
#include "render/cut_away.h"
#include "render/early_start.h"
#include "render/seen/edge_draws.h"

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

/// Half a wide line, and a pixel of fade.
float halfReach(const FrameContext& context, float width) {
    return 0.5f * width * context.frame.pixelRatio + 1.0f;
}

void setWideLine(const gl::Program& program, const FrameContext& context, float width) {
    program.set("u_halfSize", 0.5f * glm::vec2(context.frame.width, context.frame.height));
    program.set("u_halfWidth", 0.5f * width * context.frame.pixelRatio);
    program.set("u_reach", halfReach(context, width));
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

LineReach edgeReach(const FrameContext& context) {
    return {static_cast<int>(std::ceil(halfReach(context, kLineWidth))) + 1, depthShift(context)};
}

/// Logical pixels of edges that are drawn as wide lines, and longer ones.
float wideFrom(const FrameContext& context, const EdgeStyle& style) {
    return style.faint && context.frame.pixelRatio < kSmallPixels ? std::numeric_limits<float>::infinity()
                                                                  : kWideFrom;
}

std::vector<EdgeDraw> edgeDraws(const FrameContext& context, const DeformationPipeline& pipeline,
                                const EdgeStyle& style) {
    const LineReach reach = edgeReach(context);
    std::vector<EdgeDraw> draws;
    for (const DrawItem& item : context.frame.targets) {
        if (nearestEdgePixels(context, item) >= style.leastPixels) {
            draws.push_back(edgeDraw(context, pipeline, item, reach, style.ghost));
        }
    }
    if (!style.faint) {  // else what is hidden is what they are drawn for
        leaveOutHidden(context, pipeline, draws, reach);
    }
    std::erase_if(draws, [](const EdgeDraw& draw) { return draw.seen.empty(); });
    return draws;
}

Status drawEdgesOf(const FrameContext& context, DeformationPipeline& pipeline,
                   std::span<const EdgeDraw> draws, const EdgeStyle& style, bool wide) {
    const ClipByCut clip(context.frame);
    const gl::Program* program = nullptr;
    const glm::vec4 selected(glm::mix(glm::vec3(style.colour), context.colours.accent, style.selectionTint),
                             style.colour.a);
    EarlyStart earlyStart(context);
    for (const EdgeDraw& draw : draws) {
        const DrawItem& item = *draw.item;
        if ((nearestEdgePixels(context, item) >= wideFrom(context, style)) != wide) {
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
        earlyStart.drawn(drawRuns(GL_LINES, draw.seen));
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
    const std::vector<EdgeDraw> draws = edgeDraws(context, pipeline, style);
    if (Status status = drawEdgesOf(context, pipeline, draws, style, false); !status) {
        return status;
    }
    return drawEdgesOf(context, pipeline, draws, style, true);
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
