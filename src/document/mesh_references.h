// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// Another file that a mesh file names and that its import reads.
struct MeshReference {
    QString name;  ///< as the file has it
    QString path;  ///< canonical; in the mesh's folder or below it, as all that an import may read
    enum class Kind : std::uint8_t {
        Data,           ///< materials, buffers
        Picture,        ///< found where the name leads
        PictureByName,  ///< found in the mesh's folder by the last part of its name
    };
    Kind kind = Kind::Data;
};

/// The material files and pictures of a mesh that was read from `meshPath`; those that are not there are left
/// out. Looks at the disk; on any thread.
[[nodiscard]] std::vector<MeshReference> referencesOf(const QString& meshPath, const MeshData& mesh);

/// The buffers of a glTF, which its shape comes from; other files have none. Those that are not there are
/// left out. Looks at the disk; on any thread.
[[nodiscard]] std::vector<MeshReference> buffersOf(const QString& meshPath);

/// referencesOf(), and what the file itself has to be read for: the buffers and pictures of a glTF.
[[nodiscard]] std::vector<MeshReference> allReferencesOf(const QString& meshPath, const MeshData& mesh);

}  // namespace hitscope
