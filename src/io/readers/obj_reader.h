// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// Parses Wavefront OBJ text; pure. Keeps the file's vertex order, unused vertices, polygons, texture
/// coordinates, normals, objects, groups, smoothing groups, lines, points and vertex colours. Materials are
/// those that usemtl names, in the order of first use, with default values: readMaterialLibraries() fills
/// them in. Errors name the line. Long texts are read on several threads at once.
///
/// Own code, although tinyobjloader reads the MTL: tinyobjloader's numbers are not correctly rounded (its
/// doubles are sums of powers of ten), a word that is not a number reads as zero, its face sizes are bytes,
/// and its callback interface knows no line numbers, smoothing groups, lines or points.
[[nodiscard]] Result<ImportedMesh> parseObj(std::string_view text, const ProgressSink& progress = {});

/// The same in so many parts at once, whatever the text's length; parts >= 1. Gives the same mesh and the
/// same errors.
[[nodiscard]] Result<ImportedMesh> parseObjInParts(std::string_view text, std::size_t parts,
                                                   const ProgressSink& progress = {});

}  // namespace hitscope
