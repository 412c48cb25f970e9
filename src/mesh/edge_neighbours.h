// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/render_mesh.h"

namespace hitscope {

/// The vertices at the other end of each file vertex's edges, those of the file's polygons.
class EdgeNeighbours {
public:
    EdgeNeighbours() = default;
    explicit EdgeNeighbours(const RenderMesh& render);

    [[nodiscard]] bool empty() const { return m_starts.empty(); }
    /// File vertices, in no order.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t fileVertex) const {
        return std::span(m_neighbours)
            .subspan(m_starts[fileVertex], m_starts[fileVertex + 1] - m_starts[fileVertex]);
    }

private:
    std::vector<std::uint32_t> m_starts;  ///< one a file vertex and one more
    std::vector<std::uint32_t> m_neighbours;
};

/// Change in length of the vertex's edge that changed most, percent; negative is shorter. An edge that had no
/// length is passed over. `original` and `current`: file vertices' positions.
[[nodiscard]] double edgeStretch(const EdgeNeighbours& neighbours, std::uint32_t fileVertex,
                                 std::span<const glm::vec3> original, std::span<const glm::vec3> current);

}  // namespace hitscope
