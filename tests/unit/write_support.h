// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "io/readers/read_mesh.h"
#include "io/writers/mesh_export.h"
#include "io_support.h"

namespace hitscope::test {

/// A mesh read from a file, and a deformed state of it.
struct DentedFile {
    ImportedMesh original;
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> hits;
    std::vector<glm::vec3> normals;
    QString sourcePath;

    explicit DentedFile(const QString& path) : sourcePath(path) {
        Result<ImportedMesh> imported = readMesh(path, {});
        if (!imported) {
            qWarning("%s", imported.error().message().c_str());
            return;
        }
        original = std::move(imported.value());
        positions.assign(original.mesh.positions.begin(), original.mesh.positions.end());
        hits.resize(positions.size());
    }
    void move(std::size_t vertex, const glm::vec3& by) {
        positions[vertex] += by;
        ++hits[vertex];
    }
    [[nodiscard]] MeshExport what() const {
        MeshExport what;
        what.mesh = &original.mesh;
        what.positions = positions;
        what.normals = normals;
        what.hits = hits;
        what.sourcePath = sourcePath;
        return what;
    }
};

/// What was written, as it is read back; empty with a warning where it cannot be.
inline MeshData readBack(const QString& path) {
    Result<ImportedMesh> imported = readMesh(path, {});
    if (!imported) {
        qWarning("%s", imported.error().message().c_str());
        return {};
    }
    return std::move(imported.value().mesh);
}

}  // namespace hitscope::test
