// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>

#include "core/result.h"

namespace hitscope::bench {

/// Vertices of a sheet of about so many quads.
[[nodiscard]] std::size_t gridVertices(int quads);

/// Writes a bent sheet of about so many quads to an OBJ file, with texture coordinates and normals (62 bytes
/// a quad: 2,000,000 are 124 MB). Many vertices share them, so that there is as little text as can be for so
/// many faces. quads >= 1.
[[nodiscard]] Status writeGridObj(const QString& path, int quads);

/// A bent sheet of about so many triangles, as a binary PLY file: positions and faces. triangles >= 2.
[[nodiscard]] Status writeGridPly(const QString& path, int triangles);

}  // namespace hitscope::bench
