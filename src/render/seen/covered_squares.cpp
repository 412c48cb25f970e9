// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen/covered_squares.h"

#include <cmath>
#include <glm/vec4.hpp>
#include <optional>

#include "render/seen/visible_runs.h"

namespace hitscope::render {
namespace {

/// Nothing: the point is not in the picture.
std::optional<std::size_t> squareOf(const glm::mat4& toClip, const glm::vec3& point, int side) {
    const glm::vec4 clip = toClip * glm::vec4(point, 1.0f);
    if (!(std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w)) {
        return std::nullopt;
    }
    const float half = 0.5f * static_cast<float>(side);
    const auto column = static_cast<std::size_t>(half * (clip.x / clip.w + 1.0f));
    const auto row = static_cast<std::size_t>(half * (clip.y / clip.w + 1.0f));
    const auto last = static_cast<std::size_t>(side - 1);
    return std::min(row, last) * static_cast<std::size_t>(side) + std::min(column, last);
}

}  // namespace

void CoveredSquares::cover(const glm::mat4& toClip, const ClusterRuns& runs,
                           std::span<const IndexRun> drawn) {
    forEachPart(drawn, runs, [&](const ClusterRuns::Run& run, const IndexRun&) {
        if (const auto square = squareOf(toClip, run.bounds.centre(), kSide)) {
            m_isCovered[*square] = true;
        }
    });
}

std::size_t CoveredSquares::covered(const glm::mat4& toClip, const ClusterRuns& runs,
                                    std::span<const IndexRun> behind) const {
    std::size_t indices = 0;
    forEachPart(behind, runs, [&](const ClusterRuns::Run& run, const IndexRun& part) {
        const auto square = squareOf(toClip, run.bounds.centre(), kSide);
        indices += square && m_isCovered[*square] ? part.end - part.first : 0;
    });
    return indices;
}

}  // namespace hitscope::render
