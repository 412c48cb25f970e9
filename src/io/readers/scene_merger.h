// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/imported_mesh.h"
#include "io/welder.h"

struct aiMesh;
struct aiScene;

namespace hitscope {

/// How a format's meshes are taken over.
struct SceneMerging {
    bool weld = false;   ///< vertices at the same place are one
    bool morph = false;  ///< by the weights of the file
};

/// Adds instances of Assimp's meshes to one MeshData.
class SceneMerger {
public:
    /// Both outlive this.
    SceneMerger(const aiScene& scene, ImportedMesh& imported, SceneMerging how)
        : m_scene(scene), m_imported(imported), m_how(how), m_welder(imported.mesh.positions) {}

    /// Nodes whose matrix places nothing, and faces of vertices that are not there, are errors.
    [[nodiscard]] Status merge();
    [[nodiscard]] bool hasMorphed() const { return m_hasMorphed; }

private:
    Status addInstance(const aiMesh& mesh, const glm::dmat4& transform);
    void beginGroup(const std::string& name);
    void addVertices(const aiMesh& mesh, const glm::dmat4& transform);
    Status addFaces(const aiMesh& mesh, bool mirrored);
    void addColours(const aiMesh& mesh);
    [[nodiscard]] std::uint32_t attributeIndex(bool has, std::size_t base, unsigned index) const {
        return has ? static_cast<std::uint32_t>(base + index) : kNoIndex;
    }

    const aiScene& m_scene;
    ImportedMesh& m_imported;
    MeshData& m_mesh = m_imported.mesh;
    SceneMerging m_how;
    bool m_hasMorphed = false;
    Welder<> m_welder;
    const aiMesh* m_before = nullptr;       ///< of the same node, whose vertices m_vertexOf has; null: none
    std::vector<std::uint32_t> m_vertexOf;  ///< of the mesh being added: its vertex -> ours
    std::size_t m_texcoordBase = 0;
    std::size_t m_normalBase = 0;
    std::vector<glm::vec3> m_colours;
    bool m_anyColour = false;
};

}  // namespace hitscope
