// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "io/writers/export_step.h"
#include "mesh/mesh_data.h"
#include "mesh/moved_vertex.h"

namespace hitscope {

/// The shape after one more group of hits.
struct MorphStep {
    std::string name;                ///< for people: "Hits 5-8"
    std::vector<MovedVertex> moved;  ///< those that these hits moved, where they are then; each once
};

/// What is written: the original and what hits made of it. The original gives order, polygons, groups and
/// materials.
struct MeshExport {
    const MeshData* mesh = nullptr;
    std::span<const glm::vec3> positions;  ///< deformed, metres, local frame; one a vertex
    std::span<const glm::vec3> normals;    ///< deformed, unit length; empty or one a corner
    std::span<const std::uint32_t> hits;  ///< how many hits moved a vertex; empty (not known) or one a vertex
    std::vector<MorphStep> steps;         ///< in their order; glTF writes them where it is asked to
    QString sourcePath;                   ///< the mesh's file; empty: none
    /// What that file holds, where `mesh` is the same one elsewhere (placeTarget()); else null.
    const MeshData* asRead = nullptr;
    QString sourceFolder;              ///< where its pictures are; empty: sourcePath's
    ExportGoOn goOn;                   ///< called now and then
    std::function<void()> beforeStep;  ///< StagedFiles' own; for tests

    [[nodiscard]] const MeshData& inFile() const { return asRead ? *asRead : *mesh; }
};

// Writers of whole files. Coordinates are those of the mesh's file: local / placement.scale +
// placement.centre. A vertex that did not move has its file's own numbers, as far as the format holds them.
// Each gives notes in words for people: what the format does not hold, or why something was written in
// another way than asked. Errors: spans of wrong lengths, no memory, the disk's, given up; all files are then
// as they were.

struct PlyOptions {
    enum class Encoding : std::uint8_t { AsSource, Binary, Ascii };
    /// Binary: little endian, or as a binary source is. AsSource: without a PLY source, binary.
    Encoding encoding = Encoding::AsSource;
    bool displacement = true;  ///< dx, dy, dz: float, in the file's unit
    bool length = true;        ///< displacement: float, in the file's unit
    bool hits = true;          ///< hits: uint, where they are known
    bool isAlone = false;      ///< no note of the picture beside it
};

/// Where the mesh came from a PLY file that still has the same vertices and faces, that file is written again
/// with all that is in it: only x, y and z of vertices that moved, and nx, ny and nz where the normal turned,
/// are replaced, in their own types, and the new properties come last. Else the mesh is written in full.
/// The picture of its one texture is copied beside it.
[[nodiscard]] Result<QStringList> exportPly(const MeshExport& what, const QString& path,
                                            const PlyOptions& options = {});

struct StlOptions {
    bool isAscii = false;
};

/// Faces cut into triangles as the program draws them, in the file's order; normals of the deformed facets.
[[nodiscard]] Result<QStringList> exportStl(const MeshExport& what, const QString& path,
                                            const StlOptions& options = {});

struct GltfOptions {
    bool steps = false;  ///< a morph target for each of MeshExport::steps, and an animation through them
    double stepSeconds = 0.5;  ///< that one step takes in the animation, > 0
};

/// GLB for the suffix "glb", else glTF with FILE.bin and pictures beside it, under names that replace
/// nothing. The original is the base, and the deformed shape a morph target "Deformed" of weight 1. Each
/// object of the mesh is a node. Vertices are in the file's order in each primitive, those that have several
/// normals or texture coordinates once more at its end; the attribute _FILE_VERTEX has their numbers in the
/// mesh that is written, from 0. Of a mesh that was refined or simplified, _SOURCE_VERTEX has those in its
/// own file; -1: a new vertex.
[[nodiscard]] Result<QStringList> exportGltf(const MeshExport& what, const QString& path,
                                             const GltfOptions& options = {});

struct ChangesCsvOptions {
    bool allVertices = false;  ///< those that did not move too
};

/// A row for each vertex that moved: its number from 1, the original's and the deformed coordinates, the
/// displacement, its length, and hits where they are known.
[[nodiscard]] Result<QStringList> exportChangesCsv(const MeshExport& what, const QString& path,
                                                   const ChangesCsvOptions& options = {});

}  // namespace hitscope
