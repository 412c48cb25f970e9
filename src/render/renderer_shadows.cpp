// SPDX-License-Identifier: GPL-3.0-or-later
// Which shadow map a picture takes.
#include <algorithm>

#include "render/ghost_pass.h"
#include "render/renderer_private.h"

namespace hitscope {

using namespace render;

/// A coarse frame leaves the other map as it is: what has moved since is drawn there when it is wanted.
ShadowMap& Renderer::Private::shadowsFor(const FrameContext& context, const DeformationPipeline& pipeline) {
    return context.frame.coarse && !shadows.isUpToDate(context, pipeline) ? coarseShadows : shadows;
}

Status Renderer::Private::updateShadows(FrameContext& context, DeformationPipeline& pipeline) {
    if (!ShadowMap::isWanted(context.frame)) {
        return Done{};
    }
    ShadowMap& map = shadowsFor(context, pipeline);
    Status updated = map.update(context, pipeline);
    context.shadows = &map;
    return updated;
}

Status Renderer::prepare(const Frame& given, DeformationPipeline& pipeline) {
    const KeepState keep;
    const LitFrame lit(given);
    if (!ShadowMap::isWanted(lit.frame())) {
        return Done{};
    }
    const FrameContext context = d->contextOf(lit.frame());
    ShadowMap& map = d->shadowsFor(context, pipeline);
    return map.make() ? Status(Done{}) : map.update(context, pipeline);
}

bool Renderer::isPrepared(const Frame& given, const DeformationPipeline& pipeline) {
    const LitFrame lit(given);
    if (!ShadowMap::isWanted(lit.frame())) {
        return true;
    }
    const FrameContext context = d->contextOf(lit.frame());
    return d->shadowsFor(context, pipeline).isUpToDate(context, pipeline);
}

ShadowMap& Renderer::Private::originalShadowsFor(const ShadowMap& map) {
    return &map == &coarseShadows                     ? originalCoarseShadows
           : map.edges() == ShadowMap::Edges::Sampled ? originalSampleShadows
                                                      : originalShadows;
}

/// The originals' shadows from the same place on the light.
Status Renderer::Private::updateOriginalShadows(const FrameContext& context) {
    OriginalFrame originals(context.frame);
    originals.frame.lights.directional.direction = context.shadows->direction();
    // Hits do not move them; other targets are other casters.
    originals.frame.meshRevision = std::min<std::uint64_t>(originals.frame.meshRevision, 1);
    return originalShadowsFor(*context.shadows).update(contextOf(originals.frame), originalShape);
}

}  // namespace hitscope
