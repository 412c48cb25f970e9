// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "deform/deform.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// One hit's own part in where a vertex is.
struct VertexContribution {
    std::size_t hit = 0;        ///< its index in the history
    Contribution contribution;  ///< at the place where the hits before had brought the vertex
    glm::vec3 position{0.0f};   ///< metres, local frame: where the vertex is after it
};

/// Which hits brought a vertex where it is, each with its own part: follows one vertex through the hits by
/// the operations of deform(), so that it ends where a pipeline has it, in every bit.
class Attribution {
public:
    Attribution() = default;
    explicit Attribution(const DynamicVertex& original) : m_vertex(original) {}

    /// Takes the vertex through one more hit, which is enabled and on its target. Returns whether it is
    /// within its reach; if not there is no contribution.
    bool add(std::size_t index, const Hit& hit);

    /// Takes it through hits that another one, started from vertex(), has gone through.
    void append(const Attribution& further);

    [[nodiscard]] std::span<const VertexContribution> contributions() const { return m_contributions; }
    /// Position and normal after all hits so far.
    [[nodiscard]] const DynamicVertex& vertex() const { return m_vertex; }

private:
    DynamicVertex m_vertex;
    std::vector<VertexContribution> m_contributions;
};

}  // namespace hitscope
