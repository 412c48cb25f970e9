// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <glm/vec3.hpp>

#include "deform/deformed_mesh.h"

namespace hitscope {

/// What the active pipeline made of one vertex. Metres, the target's local frame.
struct VertexFacts {
    glm::vec3 original{0.0f};
    glm::vec3 current{0.0f};
    glm::vec3 displacement{0.0f};  ///< current - original
    double length = 0.0;           ///< of the displacement
    /// Unit, as the buffer holds it (the paper's, equation 2): of the corner whose normal has turned most
    /// where they differ. Zero for a vertex of no face.
    glm::vec3 normal{0.0f};
    double turned = 0.0;  ///< radians, [0, pi]: the most that a normal of it has turned
};

/// vertex < mesh.positions().size().
[[nodiscard]] VertexFacts vertexFacts(const DeformedMesh& mesh, std::uint32_t vertex);

/// Radians between two unit vectors, exact for small angles.
[[nodiscard]] double angleBetween(const glm::vec3& a, const glm::vec3& b);

/// "1,235": the number a vertex has in its file, counted from 1, as OBJ files do.
[[nodiscard]] QString vertexNumberText(std::uint32_t vertex);

}  // namespace hitscope
