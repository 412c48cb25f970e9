// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

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
    std::function<void()> beforeStep = {};  ///< StagedFiles' own; for tests
};

/// Writes FILE.obj. In the source's own folder it refers to the source's MTL files; elsewhere these are
/// copied as they are, with their pictures. A mesh that has none gets FILE.mtl with its textures, if it has
/// materials. A vertex that did not move is written with the file's own numbers, and from an OBJ file with
/// these in its own characters ("1.500", "+1", "1e3", "-0"); one that did so that reading gives the same
/// float. Normals that are the file's but for their length stay the file's. Only FILE.obj is
/// ever replaced. All files are written in full before the first gets its name, the OBJ last, so that the old
/// ones or the new ones are there whatever happens. Given up, it fails, and all is as it was.
[[nodiscard]] Status exportObj(const ObjExport& what, const QString& path);

/// The OBJ text alone, empty where it was given up; pure, for tests. materialLibraries: a name for each
/// mtllib line.
[[nodiscard]] std::string formatObj(const ObjExport& what, const std::vector<std::string>& materialLibraries);

}  // namespace hitscope
