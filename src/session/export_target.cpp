// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/export_target.h"

#include <QFileInfo>
#include <vector>

#include "io/export_obj.h"

namespace hitscope {

Status exportTarget(const Target& target, const QString& path, NormalMode normals) {
    const DeformedMesh& mesh = target.deformed;
    std::vector<glm::vec3> cornerNormals;
    cornerNormals.reserve(mesh.render().cornerRenderVertices.size());
    for (const std::uint32_t vertex : mesh.render().cornerRenderVertices) {
        cornerNormals.push_back(normals == NormalMode::True ? target.trueNormals.normals()[vertex]
                                                            : mesh.vertices()[vertex].normal);
    }
    ObjExport what;
    what.mesh = &mesh.original();
    what.positions = mesh.positions();
    what.normals = cornerNormals;
    if (!target.sourcePath.isEmpty()) {
        what.sourceFolder = QFileInfo(target.sourcePath).absolutePath();
    }
    return exportObj(what, path);
}

}  // namespace hitscope
