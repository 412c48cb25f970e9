// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

struct aiAnimMesh;
struct aiMesh;

namespace hitscope {

/// A mesh of a glTF file in the shape that its file gives it: the base with the morph targets added by the
/// mesh's default weights (glTF 2.0, 3.7.2.2).
class MorphedMesh {
public:
    /// applies: false: the base alone. The mesh has passed checkScene(), and outlives this.
    MorphedMesh(const aiMesh& mesh, bool applies);

    [[nodiscard]] bool isMorphed() const { return !m_targets.empty(); }
    [[nodiscard]] glm::vec3 position(unsigned vertex) const;
    [[nodiscard]] glm::vec3 normal(unsigned vertex) const;  ///< of a mesh that has some; unit if morphed

private:
    const aiMesh& m_mesh;
    std::vector<const aiAnimMesh*> m_targets;  ///< those with a weight
};

}  // namespace hitscope
