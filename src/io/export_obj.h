// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "core/result.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// What to write: the original gives order, polygons, texture coordinates, groups and materials, `positions`
/// and `cornerNormals` the deformed state.
struct ObjExport {
    const MeshData* mesh = nullptr;
    std::span<const glm::vec3> positions;  ///< one for each of mesh->positions
    std::span<const glm::vec3>
        normals;           ///< empty (none written), or one a corner: mesh->cornerVertices.size() entries
    QString sourceFolder;  ///< where the textures' relative paths start; empty: none to copy
    /// Called now and then with how much of the text is made, [0, 1]; false gives the export up. May be
    /// empty.
    std::function<bool(double)> goOn = {};
};

/// Writes FILE.obj, and FILE.mtl with the used textures beside it if the mesh has materials. A vertex that
/// did not move is written with the file's own numbers; one that did so that reading gives the same float.
/// Normals that are the file's but for their length stay the file's. Each file is written whole or not at
/// all, the OBJ last; other files of the same names are not overwritten, but for those of an OBJ that is
/// replaced. Given up, it fails, and an OBJ of that name and its MTL are as they were.
[[nodiscard]] Status exportObj(const ObjExport& what, const QString& path);

/// The OBJ text alone, empty where it was given up; pure, for tests. materialLibrary: the mtllib line's name,
/// empty for none.
[[nodiscard]] std::string formatObj(const ObjExport& what, const std::string& materialLibrary);

}  // namespace hitscope
