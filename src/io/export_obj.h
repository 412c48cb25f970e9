// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/writers/export_step.h"
#include "io/writers/normal_plan.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// What to write: the original gives order, polygons, texture coordinates, groups and materials, `positions`
/// and `normals` the deformed state.
struct ObjExport {
    const MeshData* mesh = nullptr;
    std::span<const glm::vec3> positions;  ///< one for each of mesh->positions
    CornerNormalView normals = {};         ///< of the deformed state; empty: those of the file, if it has any
    /// Whether corners that have no normal in the mesh's file are to get one.
    bool allNormals = false;
    QString sourceFolder = {};              ///< where the textures' relative paths start; empty: none to copy
    QString sourcePath = {};                ///< the OBJ file that the mesh was read from; empty: it was not
    const MeshData* asRead = nullptr;       ///< as in MeshExport
    bool isAlone = false;                   ///< no note of the files beside it
    ExportGoOn goOn = {};                   ///< called now and then
    std::function<void()> beforeStep = {};  ///< StagedFiles' own; for tests

    [[nodiscard]] const MeshData& inFile() const { return asRead ? *asRead : *mesh; }
};

/// Writes FILE.obj, and gives notes for the person.
///
/// If the mesh was read from an OBJ file that still has the same content, the file's bytes are copied, and
/// only these words replaced: coordinates that changed, normals that changed (see NormalPlan), and names of
/// MTL files that could not keep theirs. Else all is written anew, with a note if there was such a file: a
/// vertex that did not move keeps the file's own numbers, one that did is written so that reading gives the
/// same float.
///
/// In the source's own folder it refers to the source's MTL files; elsewhere these are copied as they are,
/// with their pictures. A mesh that has none gets FILE.mtl with its textures, if it has materials. Only
/// FILE.obj is ever replaced. All files are written in full before the first gets its name, the OBJ last, so
/// that the old ones or the new ones are there whatever happens. Given up, it fails, and all is as it was.
[[nodiscard]] Result<QStringList> exportObj(const ObjExport& what, const QString& path);

/// The OBJ text of a mesh written anew, empty where it was given up; pure, for tests. materialLibraries: a
/// name for each mtllib line.
[[nodiscard]] std::string formatObj(const ObjExport& what, const std::vector<std::string>& materialLibraries);

}  // namespace hitscope
