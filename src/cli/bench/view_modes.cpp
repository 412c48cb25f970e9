// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/view_modes.h"

#include <algorithm>
#include <array>

namespace hitscope::bench {

namespace {

using Place = ViewMode::Place;
using Extra = ViewMode::Extra;
using Options = DisplayOptions;

constexpr double kTwoFrames = 2.0;

template <ChangeQuantity quantity>
void colour(Options& options) {
    options.change.on = true;
    options.change.quantity = quantity;
}

/// Across x, at `offset` metres.
void cut(Options& options, float offset, bool fill) {
    options.cut.on = true;
    options.cut.offset = offset;
    options.cut.fill = fill;
}

void drawIsolines(Options& options) {
    colour<ChangeQuantity::Displacement>(options);
    options.change.isolines = true;
}

constexpr std::array kModes{
    ViewMode{.key = "plain", .name = "plain shading"},
    ViewMode{"wire-over", "wireframe over", [](Options& o) { o.wireframe = WireframeMode::Over; }},
    ViewMode{"wire-only", "wireframe only", [](Options& o) { o.wireframe = WireframeMode::Only; }},
    ViewMode{"flat", "flat", [](Options& o) { o.flat = true; }},
    ViewMode{"back-faces", "back faces tinted", [](Options& o) { o.backFaces = true; }},
    ViewMode{"paper-normals", "the paper's normals", [](Options& o) { o.normals = NormalMode::Paper; }},
    ViewMode{"needles", "normals as needles", [](Options& o) { o.needles = true; }},
    ViewMode{"shadows", "soft shadows", [](Options& o) { o.shadows = true; }},
    ViewMode{"vertex-colours", "colours of vertices", [](Options& o) { o.vertexColours = true; }},
    ViewMode{.key = "metal", .name = "metalness and roughness", .extra = Extra::Metal},
    ViewMode{"look-matcap", "matcap", [](Options& o) { o.look = SurfaceLook::Matcap; }},
    ViewMode{"look-clay", "clay", [](Options& o) { o.look = SurfaceLook::Clay; }},
    ViewMode{"look-metal", "metal", [](Options& o) { o.look = SurfaceLook::Metal; }},
    ViewMode{"environment", "environment light", [](Options& o) { o.environment = true; }},
    // A colour map of each way in which values come to the shader.
    ViewMode{"map-displacement", "map of displacement", colour<ChangeQuantity::Displacement>},
    ViewMode{"map-rotation", "map of normal rotation", colour<ChangeQuantity::NormalRotation>},
    ViewMode{"map-normal-error", "map of true-normal error", colour<ChangeQuantity::TrueNormalError>},
    ViewMode{"map-stretch", "map of edge stretch", colour<ChangeQuantity::EdgeStretch>},
    ViewMode{"isolines", "map of displacement, isolines", drawIsolines},
    ViewMode{"ghost-wire", "ghost, wire", [](Options& o) { o.beforeAfter.ghost = GhostMode::Wire; }},
    ViewMode{"ghost-translucent", "ghost, translucent",
             [](Options& o) { o.beforeAfter.ghost = GhostMode::Translucent; }},
    ViewMode{"wipe", "wipe", [](Options& o) { o.beforeAfter.wipe = true; }},
    ViewMode{"exaggeration", "exaggeration x5", [](Options& o) { o.beforeAfter.exaggeration = 5.0f; }},
    ViewMode{"cut", "cutting plane through the third row", [](Options& o) { cut(o, 7.5f, false); }},
    ViewMode{"cut-filled", "cutting plane that hides nothing, filled",
             [](Options& o) { cut(o, 1000.0f, true); }},
    ViewMode{.key = "selection", .name = "changed vertices selected", .extra = Extra::Selection},
    ViewMode{.key = "aim-preview", .name = "aim preview", .extra = Extra::Preview},
    ViewMode{.key = "picking", .name = "vertex under the cursor", .extra = Extra::Picking},
    ViewMode{"side-by-side", "two pipelines side by side", [](Options& o) { o.sideBySide = true; },
             Place::Overview, Extra::Comparison, kTwoFrames},
    ViewMode{"difference", "difference of two pipelines", colour<ChangeQuantity::Difference>, Place::Overview,
             Extra::Comparison, kTwoFrames},
    ViewMode{.key = "plain-close", .name = "plain shading, close", .place = Place::Close},
    ViewMode{"wire-over-close", "wireframe over, close",
             [](Options& o) { o.wireframe = WireframeMode::Over; }, Place::Close},
    ViewMode{"wire-only-close", "wireframe only, hidden lines dimmed, close",
             [](Options& o) { o.wireframe = WireframeMode::Only; }, Place::Close},
    ViewMode{"dots-close", "vertices as dots, close", [](Options& o) { o.dots = true; }, Place::Close},
    ViewMode{"needles-close", "normals as needles, close", [](Options& o) { o.needles = true; },
             Place::Close},
    ViewMode{"ghost-wire-close", "ghost, wire, close",
             [](Options& o) { o.beforeAfter.ghost = GhostMode::Wire; }, Place::Close},
};

}  // namespace

std::span<const ViewMode> viewModes() {
    return kModes;
}

const ViewMode& plainModeOf(const ViewMode& mode) {
    return *std::find_if(kModes.begin(), kModes.end(),
                         [&mode](const ViewMode& other) { return other.place == mode.place; });
}

}  // namespace hitscope::bench
