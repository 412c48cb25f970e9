// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "io/format_mtl.h"
#include "io/staged_files.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Where an export takes pictures from and brings them to.
struct ExportPlace {
    QString sourceFolder;  ///< of the mesh's file; empty: it has none
    QString folder;        ///< of the OBJ
    QString baseName;      ///< of the OBJ

    /// Files that the source names lie where the export's are looked for.
    [[nodiscard]] bool isOwnFolder() const;
};

/// Brings what a mesh's materials refer to beside its export. Only files that the import read as pictures are
/// copied, kMaxTextureBytes at most each; nothing that exists is replaced: a file of another content gets
/// another name ("wood-1.png").
class MaterialFiles {
public:
    /// All outlive this.
    MaterialFiles(const MeshData& mesh, const ExportPlace& place, StagedFiles& staged)
        : m_mesh(mesh), m_place(place), m_staged(staged) {}

    /// The MTL files that the mesh's own file names, as they are but for names of pictures that had to
    /// change, with their pictures. Gives what the OBJ's mtllib lines say. Files that cannot be read, or have
    /// no materials in them, are left out.
    [[nodiscard]] Result<std::vector<std::string>> placeLibraries();

    /// The same, for a copy of the mesh's own file: what its mtllib lines say instead, by their number from
    /// 0. Lines that stay as they are, and files that cannot be read, are left out.
    [[nodiscard]] Result<std::map<std::size_t, std::string>> placeLibraryLines();

    /// The pictures of materials that have no MTL file; those in the mesh's file alone become PNG. Gives for
    /// each material the names to refer to; textures that cannot be had keep theirs.
    [[nodiscard]] Result<std::vector<PlacedTextures>> placeTextures();

    /// One of them alone: a texture by its name and its index in the mesh's images, -1: it is not there.
    [[nodiscard]] Result<std::string> placeTexture(const std::string& name, int image);

    /// A path for a file of that content: `name` if it is free or already has this content, else
    /// "base-1.suffix", "base-2.suffix" ...
    [[nodiscard]] QString freePath(const QString& name, const QByteArray& content) const;

private:
    /// The name to refer to, "maps/wood.png"; the name itself where there is nothing to copy.
    Result<std::string> placePicture(const std::string& name, bool inItsFolder);
    Result<std::string> placeImage(int image);
    Result<std::string> placeLibrary(const QString& name);
    /// The pictures that MTL files name; those that had to change their names are noted.
    [[nodiscard]] Status placePictures();
    /// Pictures that are not where the mesh's file says, and were found elsewhere.
    [[nodiscard]] Status placeLocated();
    [[nodiscard]] bool isAtPlace(std::string_view name) const;
    [[nodiscard]] QByteArray withNewNames(const QByteArray& library, const QString& name) const;
    template <class IsSame>
    [[nodiscard]] QString freeName(const QString& name, const IsSame& isSame) const;

    const MeshData& m_mesh;
    const ExportPlace& m_place;
    StagedFiles& m_staged;
    std::map<QString, QString> m_placed;           ///< source of each picture that is placed, by its new path
    std::map<std::string, std::string> m_renamed;  ///< pictures that could not keep their names
    std::map<int, std::string> m_placedImages;     ///< each once, whatever number of materials use it
    /// The name that each got, by the one it wants and its source: a file may name one for each of its
    /// objects.
    std::map<std::pair<QString, QString>, std::string> m_placedLibraries;
};

}  // namespace hitscope
