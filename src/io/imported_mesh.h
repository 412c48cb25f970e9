// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// A mesh that was read, and what was dropped or mended on the way, in words for the person ("3 faces with
/// fewer than three corners were left out").
struct ImportedMesh {
    MeshData mesh;
    QStringList notes;
    /// Indices of materials that are opaque, whatever their texture's opacity.
    std::vector<std::size_t> opaqueMaterials = {};
};

/// Told how far a long read or write is: fraction in [0, 1] and a few words ("Reading faces"). May be empty.
using ProgressSink = std::function<void(double fraction, const char* doing)>;

}  // namespace hitscope
