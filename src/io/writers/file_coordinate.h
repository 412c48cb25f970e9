// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>

#include "io/float_text.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Whether a coordinate is the original's to the last bit. axis: 0, 1 or 2.
inline bool isStill(const MeshData& mesh, std::size_t vertex, const glm::vec3& now, int axis) {
    return std::bit_cast<std::uint32_t>(now[axis]) ==
           std::bit_cast<std::uint32_t>(mesh.positions[vertex][axis]);
}

/// A coordinate of a vertex at `now` (local frame) as the mesh's file counts it.
inline double fileCoordinate(const MeshData& mesh, std::size_t vertex, const glm::vec3& now, int axis) {
    if (!mesh.filePositions.empty() && isStill(mesh, vertex, now, axis)) {
        return mesh.filePositions[vertex][axis];
    }
    return static_cast<double>(now[axis]) / mesh.placement.scale + mesh.placement.centre[axis];
}

/// Whether a coordinate that is no longer in the mesh's frame is what a reader makes of the file's number.
inline bool isInFile(const MeshData& mesh, std::size_t vertex, const glm::vec3& now, int axis) {
    return static_cast<float>(fileCoordinate(mesh, vertex, mesh.positions[vertex], axis)) == now[axis];
}

inline constexpr std::size_t kNumberText = kFloatText;  ///< bytes that a coordinate's text takes at most

/// Writes its shortest text that reads as the same number, as the same float where a float is what it is;
/// returns its end. `to` has room for kNumberText bytes.
inline char* writeFileCoordinate(char* to, const MeshData& mesh, std::size_t vertex, const glm::vec3& now,
                                 int axis) {
    const bool isFloat =
        mesh.placement.isIdentity() && (mesh.filePositions.empty() || !isStill(mesh, vertex, now, axis));
    return isFloat ? writeFloat(to, now[axis])
                   : std::to_chars(to, to + kNumberText, fileCoordinate(mesh, vertex, now, axis)).ptr;
}

inline void appendFileCoordinate(std::string& text, const MeshData& mesh, std::size_t vertex,
                                 const glm::vec3& now, int axis) {
    char number[kNumberText];
    text.append(number, writeFileCoordinate(number, mesh, vertex, now, axis));
}

}  // namespace hitscope
