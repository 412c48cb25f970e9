// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/writers/file_positions.h"
#include "io/writers/gltf_materials.h"
#include "io/writers/gltf_morphs.h"

namespace hitscope {

/// A mesh as the parts of a glTF file: its JSON, and the buffer that is made while it is written.
class GltfParts {
public:
    /// All outlive this.
    GltfParts(const MeshExport& what, const GltfOptions& options, const ExportPlace& place,
              StagedFiles& staged, bool isGlb)
        : m_what(what),
          m_mesh(*what.mesh),
          m_options(options),
          m_positions(what),
          m_originals(originalNormals(what)),
          m_layout(layOut(what, m_originals)),
          m_materials(what, m_document, place, staged, !isGlb) {}

    Status make();  ///< Preparing is told from here on
    /// The JSON, with this as the buffer's file; empty: the one behind it.
    [[nodiscard]] QByteArray json(const QString& bufferFile);
    [[nodiscard]] const GltfDocument& document() const { return m_document; }
    [[nodiscard]] QStringList notes() const;

private:
    void tell(double share) const;
    [[nodiscard]] double laidOut() const;
    /// One node: an object of the mesh, and the targets that do anything to it.
    void addNode(std::uint32_t object);
    QJsonObject primitiveOf(const GltfPrimitive& primitive, const std::vector<const MorphTarget*>& targets);
    void addNumbers(QJsonObject& attributes, const GltfPrimitive& primitive);
    QJsonObject attributesOf(const GltfPrimitive& primitive);
    int addPositions(const GltfPrimitive& primitive);
    int addIndices(const GltfPrimitive& primitive);
    void addVectors(QJsonObject& attributes, const GltfPrimitive& primitive);
    void addAnimation(int node, const std::vector<const MorphTarget*>& targets);
    int times();

    const MeshExport& m_what;
    const MeshData& m_mesh;
    const GltfOptions& m_options;
    FilePositions m_positions;
    std::vector<glm::vec3> m_originals;  ///< normals, one a corner
    GltfLayout m_layout;
    GltfDocument m_document;
    GltfMaterials m_materials;
    MorphTarget m_deformed;
    std::vector<MorphTarget> m_steps;
    QJsonArray m_nodes;
    QJsonArray m_meshes;
    QJsonArray m_channels;
    QJsonArray m_samplers;
    int m_times = -1;
    bool m_hasLoose = false;  ///< lines or points
    std::size_t m_copies = 0;
    std::size_t m_made = 0;  ///< morph targets of primitives
};

}  // namespace hitscope
