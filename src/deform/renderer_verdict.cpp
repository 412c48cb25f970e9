// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/renderer_verdict.h"

#include "core/grouped.h"

namespace hitscope {

const PipelineVerdict* RendererVerdict::of(PipelineKind kind) const {
    const auto known = pipelines.find(kind);
    return known == pipelines.end() ? nullptr : &known->second;
}

std::optional<PipelineKind> RendererVerdict::insteadOf(PipelineKind kind) const {
    const PipelineVerdict* own = of(kind);
    if (own == nullptr || own->isExact()) {
        return std::nullopt;
    }
    for (const PipelineTraits& traits : allPipelines()) {
        const PipelineVerdict* other = of(traits.kind);
        if (traits.keepsAll && other != nullptr && other->isExact()) {
            return traits.kind;
        }
    }
    return std::nullopt;
}

std::string describe(const PipelineVerdict& verdict) {
    if (!verdict.whyNot.empty()) {
        return "not compared: " + verdict.whyNot;
    }
    if (verdict.isExact()) {
        return "bit-exact in " + grouped(verdict.compared.vertices) + " vertices compared";
    }
    return "not bit-exact: " + describe(verdict.compared);
}

std::string describe(const PickingVerdict& verdict) {
    if (!verdict.whyNot.empty()) {
        return "not compared: " + verdict.whyNot;
    }
    if (!verdict.isRight()) {
        return "wrong in " + grouped(verdict.wrong) + " of " + grouped(verdict.pixels) + " pixels compared";
    }
    return "right in " + grouped(verdict.pixels) + " pixels compared" +
           (verdict.byGeometry ? ", through a geometry shader" : "");
}

std::string describe(const RendererVerdict& verdict, PipelineKind kind) {
    const PipelineVerdict* known = verdict.of(kind);
    return std::string(pipelineTraits(kind).name) + ": " +
           (known != nullptr ? describe(*known) : "not compared yet");
}

}  // namespace hitscope
