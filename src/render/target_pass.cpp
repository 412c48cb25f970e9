// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/target_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>
#include <span>
#include <vector>

#include "render/bounded_draw.h"
#include "render/change_map.h"
#include "render/cut_away.h"
#include "render/early_start.h"
#include "render/line_pass.h"
#include "render/material_set.h"
#include "render/seen/surface_draws.h"
#include "render/seen/visible_runs.h"
#include "render/shadow_map.h"
#include "render/studio.h"
#include "render/surface_looks.h"

namespace hitscope::render {
namespace {

constexpr float kRimStrength = 0.75f;
constexpr float kRingWidth = 1.8f;  // logical pixels
constexpr float kHatch = 9.0f;      // logical pixels from one line to the next

/// It shades pixels on other processors than it transforms vertices, but starts only when told to, or at the
/// frame's end. So it is told after so many indices: pixels are shaded while vertices are transformed.
constexpr std::size_t kIndicesARound = 24576;
constexpr std::size_t kMostRounds = 8;

GLuint surfaceArrayOf(const DrawItem& item) {
    return item.original ? item.buffers->originalSurfaceArray() : item.buffers->surfaceArray();
}

bool hasMarks(const Frame& frame) {
    return frame.highlightedHit.has_value() ||
           std::any_of(frame.targets.begin(), frame.targets.end(),
                       [](const DrawItem& item) { return item.selected; });
}

/// Of a surface that is shaded.
gl::Defines lightingDefines(const FrameContext& context) {
    const Frame& frame = context.frame;
    gl::Defines defines = isStudioWanted(frame) ? studioDefines(frame) : lightDefines(frame.lights);
    const auto add = [&defines](const gl::Defines& more) {
        defines.insert(defines.end(), more.begin(), more.end());
    };
    if (context.shadows != nullptr && frame.options.look != SurfaceLook::Matcap) {
        add(context.shadows->defines());
    }
    add(occlusionDefines(context));
    return defines;
}

/// A program has what a frame needs and no more: see lighting.glsl.
gl::Defines surfaceDefines(const FrameContext& context, const DeformationPipeline& pipeline,
                           const SurfaceParts& parts) {
    const Frame& frame = context.frame;
    gl::Defines defines = targetDefines(frame, pipeline);
    addSight(defines, frame);
    if (frame.change) {
        defines.emplace_back("HITSCOPE_CHANGE_MAP", "1");
    } else {
        const gl::Defines light = lightingDefines(context);
        defines.insert(defines.end(), light.begin(), light.end());
    }
    const std::pair<const char*, bool> parted[] = {
        {"HITSCOPE_TEXCOORDS", parts.textured || parts.normalMapped || parts.metalRoughMapped},
        {"HITSCOPE_TEXTURED", parts.textured},
        {"HITSCOPE_NORMAL_MAP", parts.normalMapped},
        {"HITSCOPE_METAL_ROUGHNESS", parts.metalRough},
        {"HITSCOPE_METAL_ROUGHNESS_MAP", parts.metalRoughMapped},
        {"HITSCOPE_COLOURS", parts.coloured},
        {"HITSCOPE_TRANSLUCENT", parts.translucent},
        {"HITSCOPE_FLAT", frame.options.flat},
        {"HITSCOPE_BACK_FACES", frame.options.backFaces && !frame.change},
        {"HITSCOPE_CUT_FILLED", isCutFilled(frame) && !parts.translucent},
        {"HITSCOPE_MARKS", hasMarks(frame)},
        {"HITSCOPE_PAPER_NORMALS", frame.options.normals == NormalMode::Paper}};
    for (const auto& [name, wanted] : parted) {
        if (wanted) {
            defines.emplace_back(name, "1");
        }
    }
    return defines;
}

void setSurface(const gl::Program& program, const FrameContext& context) {
    const Frame& frame = context.frame;
    if (frame.change) {
        setChangeMap(program, context);
    } else {
        setLights(program, context);
        setOcclusion(program, context,
                     context.occlusion != nullptr ? context.occlusion->jitter : glm::vec2(0.0f));
        if (context.studio != nullptr) {
            context.studio->apply(program, frame);
        }
    }
    setDrawnPlace(program, frame);
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_eye", context.eye);
    setSight(program, frame);
    if (hasMarks(frame)) {
        program.set("u_ring", frame.highlightedHit ? glm::vec4(frame.highlightedHit->centre - context.eye,
                                                               frame.highlightedHit->radius)
                                                   : glm::vec4(0.0f));
        program.set("u_ringColour", toLinear(context.colours.accent));
        program.set("u_ringWidth", std::max(1.0f, kRingWidth * frame.pixelRatio));
    }
    if (isCutFilled(frame)) {
        setCutFill(program, frame);
        program.set("u_fillColour", context.colours.cutFill);
        program.set("u_hatch", kHatch * frame.pixelRatio);
    }
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
    if (context.shadows != nullptr && !frame.change) {
        context.shadows->apply(program);
    }
}

void prepareSurface(const gl::Program& program, const FrameContext& context, DeformationPipeline& pipeline,
                    const DrawItem& item) {
    pipeline.prepareDraw(program, item.target);
    program.set("u_model", item.model);
    program.set("u_rim", glm::vec4(toLinear(context.colours.accent), item.selected ? kRimStrength : 0.0f));
    glBindVertexArray(surfaceArrayOf(item));
}

/// How many indices a round has. In a picture's part there are fewer rounds: each costs the whole picture's
/// pixels a little.
std::size_t roundOf(std::span<const SurfaceDraw> draws, std::uint32_t parts) {
    return std::max(kIndicesARound, indicesFrom(draws, 0) / (parts > 1 ? 2 : kMostRounds));
}

/// draws: one at least, all for one program.
Status drawWithOneProgram(const FrameContext& context, DeformationPipeline& pipeline,
                          std::span<SurfaceDraw> draws) {
    const SurfaceParts& parts = draws.front().parts;
    const auto found =
        context.programs.get("surface.vert", "surface.frag", surfaceDefines(context, pipeline, parts));
    if (!found) {
        return found.error();
    }
    const ClipByCut clip(context.frame);
    const gl::Program& program = *found.value();
    program.use();
    setSurface(program, context);
    const DrawOrder order = parts.translucent ? DrawOrder::AsGiven : DrawOrder::Any;
    const std::size_t round = roundOf(draws, context.part.count);
    std::size_t drawn = 0;
    for (std::size_t group = 0; group < kSurfaceGroups; ++group) {
        if (group == kSurfaceGroups / 2) {
            leaveOutHidden(context, pipeline, draws, group);
        }
        const DrawItem* prepared = nullptr;
        for (const SurfaceDraw& draw : draws) {
            if (group >= draw.groups.size() || draw.groups[group].empty()) {
                continue;
            }
            if (prepared != draw.item) {
                prepareSurface(program, context, pipeline, *draw.item);
                prepared = draw.item;
            }
            materialsOf(context.frame, *draw.item)
                .apply(program, draw.range.material, parts.coloured, context.textureSampler);
            const std::vector<IndexRun>& runs = draw.groups[group];
            drawn += drawBounded(context, GL_TRIANGLES, runs, {runs.front().first, runs.back().end}, order);
            if (context.software && drawn >= round) {
                glFlush();
                drawn = 0;
            }
        }
    }
    return Done{};
}

Status drawAllParts(const FrameContext& context, DeformationPipeline& pipeline, bool translucent) {
    std::vector<SurfaceDraw> draws = surfaceDraws(context, pipeline, translucent);
    for (auto first = draws.begin(); first != draws.end();) {
        const auto last = std::find_if(first, draws.end(), [parts = first->parts](const SurfaceDraw& draw) {
            return draw.parts != parts;
        });
        if (Status status = drawWithOneProgram(context, pipeline, std::span(first, last)); !status) {
            return status;
        }
        first = last;
    }
    return Done{};
}

/// Before its near plane as well.
glm::mat4 withoutDepth(glm::mat4 toClip) {
    for (int column = 0; column < 4; ++column) {
        toClip[column][2] = 0.0f;
    }
    return toClip;
}

}  // namespace

Status drawSurfaces(const FrameContext& context, DeformationPipeline& pipeline) {
    return drawAllParts(context, pipeline, false);
}

Status drawTranslucentSurfaces(const FrameContext& context, DeformationPipeline& pipeline) {
    return drawAllParts(context, pipeline, true);
}

Status drawSurfaceDepth(const FrameContext& context, DeformationPipeline& pipeline,
                        const glm::mat4& viewProjection, DepthOf what, float leastEdge,
                        const std::optional<PictureWindow>& within, const TilesOfPicture& tiles) {
    const gl::Defines defines = what == DepthOf::Whole ? wholeTargetDefines(context.frame, pipeline)
                                                       : targetDefines(context.frame, pipeline);
    const auto found = context.programs.get("surface.vert", "depth.frag", defines);
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    std::optional<ClipByCut> clip;
    if (what == DepthOf::Seen) {
        clip.emplace(context.frame);
    }
    // What lies before the near plane casts shadows, too: GL_DEPTH_CLAMP.
    const glm::mat4 sight = what == DepthOf::Whole ? withoutDepth(viewProjection) : viewProjection;
    program.use();
    program.set("u_viewProjection", viewProjection);
    setDrawnPlace(program, context.frame);
    EarlyStart earlyStart(context);
    for (const DrawItem& item : context.frame.targets) {
        if (!context.mayShow(item, pipeline) || nearestEdgePixels(context, item) < leastEdge) {
            continue;
        }
        pipeline.prepareDraw(program, item.target);
        program.set("u_model", item.model);
        glBindVertexArray(surfaceArrayOf(item));
        const std::span<const DrawRange> draws = hitscope::drawsOf(item, context.frame.coarse);
        const bool isCoarse = draws.data() != item.buffers->draws().data();
        if (!draws.empty()) {
            const DrawRange& last = draws.back();
            const DrawRange all{draws.front().first, last.first + last.count - draws.front().first};
            const DrawRange drawn = context.part.of(all);
            const IndexRun range{drawn.first, drawn.first + drawn.count};
            std::optional<std::vector<IndexRun>> seen;
            if (within) {
                Sight itemSight(sight * item.model, *within);
                itemSight.limitTo(tiles);
                seen =
                    visibleRuns(item, context.frame, pipeline, itemSight,
                                isCoarse ? item.buffers->coarseRuns() : item.buffers->triangleRuns(), range);
            }
            if (seen) {
                drawBounded(context, GL_TRIANGLES, *seen, range, DrawOrder::Any);
            } else {
                drawBounded(context, GL_TRIANGLES, range, DrawOrder::Any);
            }
            earlyStart.drawn(drawn.count / kIndicesPerVertex);
        }
    }
    return Done{};
}

}  // namespace hitscope::render
