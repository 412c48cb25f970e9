// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "mesh/cluster_runs.h"
#include "render/index_runs.h"

namespace hitscope::render {

/// About where in a picture something has been drawn, by squares of a large part of it: tells for little
/// whether a look at its depths may be worth what it costs.
class CoveredSquares {
public:
    /// The triangles of these clusters are drawn. toClip: from the frame of their boxes; what of them has
    /// moved counts as where it was.
    void cover(const glm::mat4& toClip, const ClusterRuns& runs, std::span<const IndexRun> drawn);
    /// How many indices of these are in covered squares.
    [[nodiscard]] std::size_t covered(const glm::mat4& toClip, const ClusterRuns& runs,
                                      std::span<const IndexRun> behind) const;

private:
    static constexpr int kSide = 32;  ///< squares in the picture each way

    static std::size_t indexOf(const glm::ivec2& square) {
        return static_cast<std::size_t>(square.y) * kSide + static_cast<std::size_t>(square.x);
    }

    std::array<bool, std::size_t{kSide} * kSide> m_isCovered{};
};

}  // namespace hitscope::render
