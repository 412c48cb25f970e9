// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "core/result.h"
#include "io/writers/mesh_export.h"
#include "io/writers/normal_plan.h"

namespace hitscope {

/// The normals that a writer was given.
struct WrittenNormals {
    CornerNormalView corners = {};  ///< of the deformed state; empty: none
    bool all = false;               ///< OBJ: corners that have none in the mesh's file got one
};

/// Reads a file that was just written and holds it against what was meant: numbers of vertices and faces,
/// every face, and every coordinate as far as the file's numbers are exact; then normals, texture coordinates
/// and materials, as far as the format holds them. OBJ, PLY and STL are read as any file that is opened
/// (importMesh(), which needs a QCoreApplication); glTF with its morph targets: the original, "Deformed", and
/// all steps together. The error names the first difference. `what` is in the file's frame as its writer got
/// it; what a text of another suffix holds is not looked at. goOn is told only: throws GivenUp where the
/// thread's GiveUpScope says so.
[[nodiscard]] Status verifyWritten(const QString& path, const MeshExport& what, const WrittenNormals& normals,
                                   const ExportGoOn& goOn = {});
/// With what.normals.
[[nodiscard]] Status verifyWritten(const QString& path, const MeshExport& what);

/// The part of it for glTF and GLB.
[[nodiscard]] Status verifyWrittenGltf(const QString& path, const MeshExport& what,
                                       const ExportGoOn& goOn = {});

/// How an error about that file reads.
[[nodiscard]] Error notAsMeant(const QString& path, const std::string& difference);
/// "vertex 7 is at 1 2 3 and should be at 1 2 4"
[[nodiscard]] std::string elsewhere(const std::string& which, const glm::dvec3& is, const glm::dvec3& meant);

}  // namespace hitscope
