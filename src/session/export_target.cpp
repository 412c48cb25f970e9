// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/export_target.h"

#include <QFileInfo>
#include <new>

#include "io/export_obj.h"

namespace hitscope {

TargetExport copyForExport(const Target& target, NormalMode normals) {
    const DeformedMesh& mesh = target.deformed;
    TargetExport copy;
    copy.original = mesh.sharedOriginal();
    copy.render = mesh.sharedRender();
    copy.positions.assign(mesh.positions().begin(), mesh.positions().end());
    if (normals == NormalMode::True) {
        copy.normals.assign(target.trueNormals.normals().begin(), target.trueNormals.normals().end());
    } else {
        copy.normals.reserve(mesh.vertices().size());
        for (const DynamicVertex& vertex : mesh.vertices()) {
            copy.normals.push_back(vertex.normal);
        }
    }
    if (!target.sourcePath.isEmpty()) {
        copy.sourceFolder = QFileInfo(target.sourcePath).absolutePath();
    }
    return copy;
}

Status writeExport(const TargetExport& what, const QString& path, const std::function<bool(double)>& goOn) {
    std::vector<glm::vec3> cornerNormals;
    try {
        cornerNormals.reserve(what.render->cornerRenderVertices.size());
        for (const std::uint32_t vertex : what.render->cornerRenderVertices) {
            cornerNormals.push_back(what.normals[vertex]);
        }
    } catch (const std::bad_alloc&) {
        return Error{"There is not enough memory to write the mesh.", path.toStdString(),
                     "Close other programs."};
    }
    ObjExport file;
    file.mesh = what.original.get();
    file.positions = what.positions;
    file.normals = cornerNormals;
    file.sourceFolder = what.sourceFolder;
    file.goOn = goOn;
    return exportObj(file, path);
}

Status exportTarget(const Target& target, const QString& path, NormalMode normals) {
    return writeExport(copyForExport(target, normals), path);
}

}  // namespace hitscope
