// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "deform/effects.h"

namespace hitscope {

/// Which hits made a dent of one mesh. Follows the hits at the cost of what changes between calls.
class DentHits {
public:
    /// `hits`: those applied to the mesh, in order.
    void follow(const std::shared_ptr<const RenderMesh>& mesh, std::span<const Hit> hits);
    /// The corner of a triangle (three file vertices each) that a hit moved farthest; nothing: it moved none.
    /// If it moved another vertex farther, by where all hits together left them.
    [[nodiscard]] std::optional<std::uint32_t> deepestOf(std::size_t hit,
                                                         std::span<const std::uint32_t> triangles,
                                                         std::span<const glm::vec3> before,
                                                         std::span<const glm::vec3> after) const;
    /// Those that moved some of `vertices` (of the file, ascending), ascending. `box` holds where these were
    /// and are.
    [[nodiscard]] std::vector<std::size_t> madeBy(std::span<const std::uint32_t> vertices,
                                                  const Bounds& box) const;

    [[nodiscard]] const RenderMesh& mesh() const { return *m_mesh; }
    [[nodiscard]] std::vector<Hit> hitsAt(std::span<const std::size_t> indices) const;

private:
    std::shared_ptr<const RenderMesh> m_mesh;
    std::unique_ptr<TargetEffects> m_effects;
    std::vector<Hit> m_hits;
};

/// "hit 3", "hits 3 and 7", "hits 1, 2, 3, 4 and 12 more": numbers from 1, of these rows of the history.
[[nodiscard]] QString hitNumbersText(std::span<const std::size_t> rows);

}  // namespace hitscope
