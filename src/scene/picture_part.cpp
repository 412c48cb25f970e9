// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture_part.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "analysis/comparison.h"

namespace hitscope {

namespace {

/// One picture, cut at the wipe's line.
void addSides(std::vector<PicturePart>& parts, const SceneGpu::View& view, int left) {
    PicturePart part{view, left, 0, view.width};
    part.view.options.sideBySide = false;
    BeforeAfterOptions& shown = part.view.options.beforeAfter;
    if (!shown.wipe) {
        parts.push_back(part);
        return;
    }
    const int line = static_cast<int>(std::lround(shown.wipeAt * static_cast<float>(view.width)));
    const BeforeAfterOptions deformed = shown;
    shown = {};
    shown.wipe = true;
    shown.wipeAt = 1.0f;
    part.to = line;
    parts.push_back(part);
    shown = deformed;
    shown.wipe = false;
    part.from = line;
    part.to = view.width;
    parts.push_back(part);
}

}  // namespace

std::vector<PicturePart> partsOf(const SceneGpu::View& view) {
    std::vector<PicturePart> parts;
    SceneGpu::View one = view;
    const bool two = view.options.sideBySide && view.comparison != nullptr && view.comparison->other();
    if (two) {
        one.width = view.width / 2;
        addSides(parts, one, 0);
    }
    const int left = two ? one.width : 0;
    one.width = view.width - left;
    addSides(parts, one, left);
    return parts;
}

bool showsOriginals(const SceneGpu::View& view) {
    return view.options.beforeAfter.wipe && view.options.beforeAfter.wipeAt >= 1.0f;
}

float shownBy(const SceneGpu::View& view, const Target& target, std::uint32_t vertex) {
    if (!view.options.cut.on) {
        return std::numeric_limits<float>::infinity();
    }
    const glm::vec3 place = target.transform.toWorld(drawnPlace(view, target, vertex));
    return glm::dot(view.options.cut.kept(), glm::vec4(place, 1.0f));
}

glm::vec3 drawnPlace(const SceneGpu::View& view, const Target& target, std::uint32_t vertex) {
    const glm::vec3& original = target.deformed.original().positions[vertex];
    if (showsOriginals(view)) {
        return original;
    }
    const glm::vec3& position = target.deformed.positions()[vertex];
    const float factor = view.options.beforeAfter.exaggeration;
    return factor == 1.0f ? position : original + factor * (position - original);
}

}  // namespace hitscope
