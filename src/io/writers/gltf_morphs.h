// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/writers/gltf_document.h"
#include "io/writers/gltf_layout.h"

namespace hitscope {

/// What a morph target does to a file vertex.
struct MorphDelta {
    std::uint32_t vertex = 0;
    glm::vec3 moved{0.0f};  ///< in the file's unit
    float turned = 0.0f;    ///< its share of how the vertex's normals turn in all, [0, 1]
};

struct MorphTarget {
    std::string name;
    std::vector<MorphDelta> deltas;  ///< by vertex, each once
};

/// "Deformed", which takes the original to the deformed shape; no deltas where nothing moved or turned.
[[nodiscard]] MorphTarget deformedTarget(const MeshExport& what, std::span<const glm::vec3> originalNormals);

/// One for each step, which together do what "Deformed" does. What the steps lack of the deformed shape is in
/// the last of them. told: with how much is done, [0, 1].
[[nodiscard]] std::vector<MorphTarget> stepTargets(const MeshExport& what, const MorphTarget& deformed,
                                                   const std::function<void(double)>& told);

/// Adds a primitive's part of a target to the document: {"POSITION": accessor, "NORMAL": accessor}, without
/// normals for lines and points; sparse where few vertices move. What it refers to outlives the document.
[[nodiscard]] QJsonObject addMorph(GltfDocument& document, const GltfPrimitive& primitive,
                                   const MorphTarget& target, const MeshExport& what,
                                   std::span<const glm::vec3> originalNormals);

/// Whether a target does anything to a primitive.
[[nodiscard]] bool isReached(const GltfPrimitive& primitive, const MorphTarget& target);

/// Unit length; along z for what has no direction.
[[nodiscard]] glm::vec3 unitNormal(const glm::vec3& normal);

}  // namespace hitscope
