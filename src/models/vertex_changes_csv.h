// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/result.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Changed vertices of one target as they were at one moment, apart from the session: to be written on any
/// thread.
struct VertexChangesTable {
    std::shared_ptr<const MeshData> original;
    std::vector<std::uint32_t> rows;  ///< file vertices
    struct Row {
        glm::vec3 current{0.0f};
        float turned = 0.0f;  ///< radians
        std::uint32_t hits = 0;
    };
    std::vector<Row> values;  ///< one a row
};

/// A header line, then a line a row; numbers so that they are read back as the same floats, with a point
/// whatever the locale. Metres, degrees.
[[nodiscard]] QByteArray csv(const VertexChangesTable& table);
/// The same into a file, whole or not at all. The error names the file.
[[nodiscard]] Status saveCsv(const VertexChangesTable& table, const QString& path);

}  // namespace hitscope
