// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>
#include <cstddef>
#include <cstdint>

namespace hitscope {

/// What a glTF or GLB file of version 1 or 2 makes, as its JSON says it.
struct GltfCounts {
    std::uint64_t triangles = 0;  ///< of all meshes in its scene, each once
};

/// Looks at a file's JSON alone, and refuses (BadGltf) what would take time and memory out of all proportion,
/// or lead astray who reads its numbers: nodes with two parents, which double with every step down; numbers
/// beyond the end of their buffers (`folder`: where buffers' files are); attributes of different lengths; and
/// more vertices, with all instances, than fit into memory.
[[nodiscard]] GltfCounts checkGltf(const QJsonObject& root, std::size_t fileSize, const QString& folder);

}  // namespace hitscope
