// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "physics/run_array.h"
#include "physics/triangle_tree.h"

namespace hitscope::physics {

/// The outermost vertices of a surface in some dozens of directions: a hull that is good enough to tumble on.
/// The tree's boxes lead to them, so that a fine mesh is not gone through.
class Outermost {
public:
    /// `tree` is that of the triangles at `vertices`, metres.
    Outermost(const TriangleTree& tree, const RunPositions& vertices);

    /// The same surface after these vertices moved. Costs by them; only where one that was outermost sank the
    /// tree is searched.
    void follow(const TriangleTree& tree, const RunPositions& vertices, std::span<const std::uint32_t> moved);
    [[nodiscard]] std::vector<glm::vec3> points() const;  ///< each once

private:
    struct Support {
        glm::vec3 direction;
        glm::vec3 point;
        float along;  ///< dot(point, direction)
        std::uint32_t vertex;
    };
    static void extend(Support& support, const TriangleTree& tree, const RunPositions& vertices);

    std::vector<Support> m_supports;
};

}  // namespace hitscope::physics
