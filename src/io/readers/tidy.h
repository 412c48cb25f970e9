// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/imported_mesh.h"

namespace hitscope {

/// "1 face was left out ..." / "12 faces were left out ...".
[[nodiscard]] QString counted(std::size_t count, const char* one, const char* many);

/// Sets positions from the file's own numbers, and keeps those where a float does not hold them. A shape that
/// lies so far from the origin that floats would not keep it is moved there (MeshData::placement).
/// An error names the first vertex (from 1) that is not finite as a float, or says that all lie closer
/// together than 1e-300.
[[nodiscard]] Status setPositions(MeshData& mesh, std::vector<glm::dvec3> filePositions);

/// Sets colours from components in [0, 1] or, if any is larger than 1, in [0, 255].
void setColours(MeshData& mesh, std::vector<glm::vec3> colours);
/// Of a format whose colours are linear; those of a MeshData are sRGB, as most formats' are.
void turnColoursToSrgb(MeshData& mesh);

/// Scales a mesh that is smaller than a micrometre or larger than 1,000 km, as place() does, with a note:
/// nothing could be shot at it otherwise, and beyond that floats would overflow.
void placeIfExtreme(ImportedMesh& imported);

/// Mends what does not stand in the way of the surface, with a note for each kind: corners that refer to
/// texture coordinates, normals or materials that do not exist or are not finite refer to none; index arrays
/// without a single entry become empty. Then placeIfExtreme().
void tidy(ImportedMesh& imported);

}  // namespace hitscope
