// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/graphics_report.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdio>

#include "core/grouped.h"
#include "gl/context.h"
#include "pipeline/deformation_pipeline.h"

namespace hitscope {

namespace {

constexpr std::size_t kNameWidth = 26;  // characters
constexpr int kStorageVersion = 43;     // epoxy's way to say 4.3

long long limit(GLenum name) {
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return value;
}

/// "16,384 bytes".
std::string counted(long long count, const std::string& unit) {
    return grouped(static_cast<std::size_t>(std::max(count, 0LL))) + " " + unit;
}

std::string timerText() {
    GLint bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    return bits > 0 ? "yes, " + std::to_string(bits) + " bits"
                    : "no: the GPU's share of a frame is not known";
}

std::string storageText(bool isThere) {
    if (!isThere) {
        return "none: they need OpenGL 4.3";
    }
    return counted(limit(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS), "in a compute shader, ") +
           counted(limit(GL_MAX_SHADER_STORAGE_BLOCK_SIZE), "bytes each");
}

std::string computeText(bool isThere) {
    return isThere
               ? "yes, " + counted(limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS), "invocations a work group")
               : "no: they need OpenGL 4.3";
}

std::string arraysText() {
    const auto arrays = makePipeline(PipelineKind::UniformArray);
    if (!arrays) {
        return arrays.error().what;
    }
    const CapacityReport report = arrays.value()->capacity();
    return std::to_string(report.capacity.value_or(0)) +
           (report.byDriver ? ", which fill what the driver has" : "");
}

void addLimits(GraphicsReport& report) {
    const bool hasStorage = epoxy_gl_version() >= kStorageVersion;
    report.emplace_back("hits in uniform arrays", arraysText());
    report.emplace_back("uniform components",
                        counted(limit(GL_MAX_VERTEX_UNIFORM_COMPONENTS), "in a vertex shader"));
    report.emplace_back("uniform blocks",
                        counted(limit(GL_MAX_VERTEX_UNIFORM_BLOCKS), "in a vertex shader, ") +
                            counted(limit(GL_MAX_UNIFORM_BLOCK_SIZE), "bytes each"));
    report.emplace_back("transform feedback", counted(limit(GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS),
                                                      "components a vertex"));
    report.emplace_back("storage buffers", storageText(hasStorage));
    report.emplace_back("texture size", counted(limit(GL_MAX_TEXTURE_SIZE), "pixels a side"));
    report.emplace_back("compute shaders", computeText(hasStorage));
    report.emplace_back("timer queries", timerText());
}

void addExactness(GraphicsReport& report, const std::optional<Exactness>& exactness) {
    if (!exactness) {
        report.emplace_back("deformation function", "not compared");
        return;
    }
    report.emplace_back("deformation function", describe(*exactness));
    char largest[32];
    std::snprintf(largest, sizeof largest, "%g m", static_cast<double>(exactness->compared.largest));
    report.emplace_back("largest difference", largest);
    report.emplace_back("division and square root",
                        exactness->byFma ? "corrected by fma" : "the driver's own");
}

void addVerdict(GraphicsReport& report, const RendererVerdict& verdict,
                const std::function<std::string(PipelineKind)>& why) {
    for (const PipelineTraits& traits : allPipelines()) {
        std::string text = why ? why(traits.kind) : std::string();
        if (text.empty()) {
            text = whyUnavailable(traits.kind).value_or(std::string());
        }
        if (text.empty()) {
            const PipelineVerdict* known = verdict.of(traits.kind);
            text = known != nullptr ? describe(*known) : "not compared yet";
        }
        report.emplace_back(std::string(traits.name), text);
    }
    report.emplace_back("picking", verdict.picking ? describe(*verdict.picking) : "not compared yet");
}

}  // namespace

GraphicsReport graphicsReport(const std::optional<Exactness>& exactness, const RendererVerdict& verdict,
                              const std::function<std::string(PipelineKind)>& why) {
    const gl::RendererInfo info = gl::rendererInfo();
    const GLubyte* language = glGetString(GL_SHADING_LANGUAGE_VERSION);
    GraphicsReport report{{"renderer", info.renderer}, {"vendor", info.vendor}, {"OpenGL", info.version}};
    report.emplace_back("GLSL", language != nullptr ? reinterpret_cast<const char*>(language) : "");
    report.emplace_back("drawn by", info.isSoftware() ? "the CPU" : "the GPU");
    addLimits(report);
    addExactness(report, exactness);
    addVerdict(report, verdict, why);
    return report;
}

std::string toText(const GraphicsReport& report) {
    std::string text;
    for (const auto& [name, value] : report) {
        const std::size_t gap = kNameWidth - std::min(name.size(), kNameWidth - 2);
        text += "  " + name + std::string(gap, ' ') + value + "\n";
    }
    return text;
}

}  // namespace hitscope
