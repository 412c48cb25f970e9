// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>

#include "io/writers/mesh_export.h"

namespace hitscope {

/// A target to be written with others, or with its transform applied.
struct PlacedTarget {
    const MeshData* mesh = nullptr;
    std::span<const glm::vec3> positions;  ///< deformed, metres, local frame; one a vertex
    std::span<const glm::vec3> normals;    ///< deformed, unit length; empty or one a corner
    std::span<const std::uint32_t> hits;   ///< empty or one a vertex
    std::span<const MorphStep> steps;      ///< of all targets: step k is the same moment
    glm::dmat4 transform{1.0};             ///< local frame to world, metres
    std::string name;                      ///< for people; empty: the mesh's
    QString sourcePath;                    ///< empty: none
};

/// Targets as one mesh in world coordinates.
struct MergedTargets {
    MeshData mesh;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3>
        normals;  ///< empty where no target has any; else true normals of the faces for those without
    std::vector<std::uint32_t> hits;  ///< empty where a target has none
    std::vector<MorphStep> steps;
    QString sourceFolder;  ///< of its pictures, where all targets have the same
    QStringList notes;

    /// To be written; this outlives it.
    [[nodiscard]] MeshExport what() const;
};

/// One target: its mesh, elsewhere. All else is as it was read, but for the file's own coordinates.
[[nodiscard]] MergedTargets placeTarget(const PlacedTarget& target);

/// Makes one object of each target (names unique; groups and objects in it become groups of it), one after
/// the other: vertices, faces, texture coordinates and normals keep their order. Materials keep their order
/// too, and pictures that were read are among the images. Placement and the files' own coordinates are gone.
/// An error: more vertices or corners than can be counted.
[[nodiscard]] Result<MergedTargets> mergeTargets(std::span<const PlacedTarget> targets);

}  // namespace hitscope
