// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.h"

namespace hitscope {

/// A glTF or GLB file before Assimp reads it.
struct PreparedGltf {
    std::uint64_t triangles = 0;  ///< of all meshes in its scene, each once
    QStringList notes;            ///< on what is not read
    std::string document;         ///< what Assimp is to read instead of the file; empty: the file itself
    std::string numbers;          ///< the buffer kDecodedGltfBuffer, to which `document` refers
};

/// Checks a file of version 1 or 2 (gltf_check.h, gltf_extensions.h), and mends what Assimp would misread:
/// numbers that are no floats (gltf_numbers.h), and a missing scene. `folder`: where buffers' files are.
[[nodiscard]] Result<PreparedGltf> prepareGltf(std::string_view file, const QString& folder);

}  // namespace hitscope
