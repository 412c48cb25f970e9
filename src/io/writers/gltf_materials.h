// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <map>

#include "io/export_files.h"
#include "io/writers/gltf_document.h"

namespace hitscope {

/// Materials, textures and images of a glTF file.
class GltfMaterials {
public:
    /// isBeside: pictures become files of their own, else they go into the document's buffer. All outlive
    /// this.
    GltfMaterials(const MeshExport& what, GltfDocument& document, const ExportPlace& place,
                  StagedFiles& staged, bool isBeside)
        : m_mesh(*what.mesh),
          m_document(document),
          m_place(place),
          m_staged(staged),
          m_isBeside(isBeside),
          m_files(m_mesh, place, staged) {}

    /// Makes all of the mesh's, and with `plain` one more for faces without one. An error of the disk.
    [[nodiscard]] Status make(bool plain);
    /// Index of a material of the mesh, or of the plain one.
    [[nodiscard]] int indexOf(std::uint32_t material) const;
    /// Adds "materials", "textures" and "images" as far as there are any.
    void addTo(QJsonObject& root) const;
    [[nodiscard]] const QStringList& notes() const { return m_notes; }

private:
    struct Picture {
        QByteArray bytes;  ///< PNG or JPEG; empty: it cannot be had
        bool isJpeg = false;
        QString name;
    };
    [[nodiscard]] Picture find(const std::string& name, int image) const;
    /// Index of a texture; -1: none.
    Result<int> texture(const std::string& name, int image);
    Result<int> addPicture(const Picture& picture);
    Status convert(const Material& material);
    [[nodiscard]] QString alphaMode(const Material& material) const;

    const MeshData& m_mesh;
    GltfDocument& m_document;
    const ExportPlace& m_place;
    StagedFiles& m_staged;
    bool m_isBeside;
    MaterialFiles m_files;
    std::map<std::pair<std::string, int>, int> m_known;  ///< textures by name and image
    QJsonArray m_materials;
    QJsonArray m_textures;
    QJsonArray m_images;
    QStringList m_notes;
};

}  // namespace hitscope
