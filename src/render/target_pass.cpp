// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/target_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/change_map.h"
#include "render/early_start.h"
#include "render/line_pass.h"
#include "render/material_set.h"
#include "render/shadow_map.h"

namespace hitscope::render {
namespace {

constexpr float kRimStrength = 0.75f;
constexpr float kRingWidth = 1.8f;  // logical pixels

const void* indexOffset(std::uint32_t first) {
    return reinterpret_cast<const void*>(std::size_t{first} * sizeof(std::uint32_t));
}

const MaterialSet& materialsOf(const DrawItem& item) {
    static const MaterialSet defaults;
    return item.materials != nullptr ? *item.materials : defaults;
}

GLuint surfaceArrayOf(const DrawItem& item) {
    return item.original ? item.buffers->originalSurfaceArray() : item.buffers->surfaceArray();
}

bool hasMarks(const Frame& frame) {
    return frame.highlightedHit.has_value() ||
           std::any_of(frame.targets.begin(), frame.targets.end(),
                       [](const DrawItem& item) { return item.selected; });
}

struct Parts {
    bool translucent = false;
    bool textured = false;
    bool normalMapped = false;

    bool operator==(const Parts&) const = default;
};

/// What a program for this material has to have.
Parts partsOf(const Frame& frame, const MaterialSet& materials, std::uint32_t material) {
    const bool pictures = !frame.change && frame.options.textures;
    return {.translucent = materials.isTranslucent(material),
            .textured = pictures && materials.isTextured(material),
            .normalMapped = pictures && !frame.options.flat && materials.hasNormalMap(material)};
}

/// A program has what a frame needs and no more: see lighting.glsl.
gl::Defines surfaceDefines(const FrameContext& context, const DeformationPipeline& pipeline,
                           const Parts& parts) {
    const Frame& frame = context.frame;
    gl::Defines defines = targetDefines(frame, pipeline);
    if (frame.change) {
        defines.emplace_back("HITSCOPE_CHANGE_MAP", "1");
    } else {
        const gl::Defines lights = lightDefines(frame.lights);
        defines.insert(defines.end(), lights.begin(), lights.end());
    }
    if (context.shadows != nullptr && !frame.change) {
        const gl::Defines shadows = context.shadows->defines();
        defines.insert(defines.end(), shadows.begin(), shadows.end());
    }
    const std::pair<const char*, bool> parted[] = {
        {"HITSCOPE_TEXCOORDS", parts.textured || parts.normalMapped},
        {"HITSCOPE_TEXTURED", parts.textured},
        {"HITSCOPE_NORMAL_MAP", parts.normalMapped},
        {"HITSCOPE_TRANSLUCENT", parts.translucent},
        {"HITSCOPE_FLAT", frame.options.flat},
        {"HITSCOPE_BACK_FACES", frame.options.backFaces && !frame.change},
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
    }
    setDrawnPlace(program, frame);
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_eye", context.eye);
    if (hasMarks(frame)) {
        program.set("u_ring", frame.highlightedHit ? glm::vec4(frame.highlightedHit->centre - context.eye,
                                                               frame.highlightedHit->radius)
                                                   : glm::vec4(0.0f));
        program.set("u_ringColour", toLinear(context.colours.accent));
        program.set("u_ringWidth", std::max(1.0f, kRingWidth * frame.pixelRatio));
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

Status drawParts(const FrameContext& context, DeformationPipeline& pipeline, const Parts& parts) {
    const gl::Defines defines = surfaceDefines(context, pipeline, parts);
    const gl::Program* program = nullptr;
    EarlyStart earlyStart(context);
    for (const DrawItem& item : context.frame.targets) {
        const MaterialSet& materials = materialsOf(item);
        bool prepared = false;
        if (!context.mayShow(item, pipeline)) {
            continue;
        }
        for (const DrawRange& range : item.buffers->draws()) {
            if (range.count == 0 || partsOf(context.frame, materials, range.material) != parts) {
                continue;
            }
            if (program == nullptr) {
                const auto found = context.programs.get("surface.vert", "surface.frag", defines);
                if (!found) {
                    return found.error();
                }
                program = found.value();
                program->use();
                setSurface(*program, context);
            }
            if (!prepared) {
                prepareSurface(*program, context, pipeline, item);
                prepared = true;
            }
            materials.apply(*program, range.material);
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.count), GL_UNSIGNED_INT,
                           indexOffset(range.first));
        }
        earlyStart.drawn(prepared ? item.buffers->vertexCount() : 0);
    }
    return Done{};
}

Status drawAllParts(const FrameContext& context, DeformationPipeline& pipeline, bool translucent) {
    for (const bool textured : {false, true}) {
        for (const bool normalMapped : {false, true}) {
            if (Status status = drawParts(context, pipeline, {translucent, textured, normalMapped});
                !status) {
                return status;
            }
        }
    }
    return Done{};
}

}  // namespace

Status drawSurfaces(const FrameContext& context, DeformationPipeline& pipeline) {
    return drawAllParts(context, pipeline, false);
}

Status drawTranslucentSurfaces(const FrameContext& context, DeformationPipeline& pipeline) {
    return drawAllParts(context, pipeline, true);
}

Status drawSurfaceDepth(const FrameContext& context, DeformationPipeline& pipeline,
                        const glm::mat4& viewProjection, float leastEdge) {
    const auto found =
        context.programs.get("surface.vert", "depth.frag", targetDefines(context.frame, pipeline));
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
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
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(item.buffers->triangleIndexCount()),
                       GL_UNSIGNED_INT, nullptr);
        earlyStart.drawn(item.buffers->vertexCount());
    }
    return Done{};
}

}  // namespace hitscope::render
