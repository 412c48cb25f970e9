// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/covered_squares.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "render/seen/visible_runs.h"

namespace hitscope::render {
namespace {

/// Of a box's diagonal, what its surface covers to each side of its middle: a little less than half a side of
/// a square.
constexpr float kCovers = 0.3f;

/// Where the middle of a box is in the picture, in squares from the lower left.
struct Middle {
    glm::vec2 place;
    float w;
};

/// Nothing: it is not in the picture.
std::optional<Middle> middleOf(const glm::mat4& toClip, const Bounds& box, int side) {
    const glm::vec4 clip = toClip * glm::vec4(box.centre(), 1.0f);
    if (!(std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w)) {
        return std::nullopt;
    }
    const float half = 0.5f * static_cast<float>(side);
    return Middle{half * (glm::vec2(clip) / clip.w + 1.0f), clip.w};
}

/// Squares each way that a metre takes where w is 1.
glm::vec2 squaresAMetre(const glm::mat4& toClip, int side) {
    const glm::vec3 across(toClip[0].x, toClip[1].x, toClip[2].x);
    const glm::vec3 up(toClip[0].y, toClip[1].y, toClip[2].y);
    return 0.5f * static_cast<float>(side) * glm::vec2(glm::length(across), glm::length(up));
}

/// The square at a place, or the nearest one.
glm::ivec2 squareAt(const glm::vec2& place, int side) {
    return glm::clamp(glm::ivec2(place), glm::ivec2(0), glm::ivec2(side - 1));
}

}  // namespace

void CoveredSquares::cover(const glm::mat4& toClip, const ClusterRuns& runs,
                           std::span<const IndexRun> drawn) {
    const glm::vec2 scale = kCovers * squaresAMetre(toClip, kSide);
    forEachPart(drawn, runs, [&](const ClusterRuns::Run& run, const IndexRun&) {
        const std::optional<Middle> middle = middleOf(toClip, run.bounds, kSide);
        if (!middle) {
            return;
        }
        const glm::vec2 reach = glm::length(run.bounds.size()) / middle->w * scale;
        const glm::ivec2 low = squareAt(middle->place - reach, kSide);
        const glm::ivec2 high = squareAt(middle->place + reach, kSide);
        for (int row = low.y; row <= high.y; ++row) {
            for (int column = low.x; column <= high.x; ++column) {
                m_isCovered[indexOf({column, row})] = true;
            }
        }
    });
}

std::size_t CoveredSquares::covered(const glm::mat4& toClip, const ClusterRuns& runs,
                                    std::span<const IndexRun> behind) const {
    std::size_t indices = 0;
    forEachPart(behind, runs, [&](const ClusterRuns::Run& run, const IndexRun& part) {
        const std::optional<Middle> middle = middleOf(toClip, run.bounds, kSide);
        const bool isCovered = middle && m_isCovered[indexOf(squareAt(middle->place, kSide))];
        indices += isCovered ? part.end - part.first : 0;
    });
    return indices;
}

}  // namespace hitscope::render
