// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/export_target.h"

#include <QFileInfo>

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
    copy.sourcePath = target.sourcePath;
    return copy;
}

Result<QStringList> writeExport(const TargetExport& what, const QString& path,
                                const std::function<bool(double)>& goOn) {
    ObjExport file;
    file.mesh = what.original.get();
    file.positions = what.positions;
    // A file that has no normals gets none; a mesh of our own has them.
    if (what.sourcePath.isEmpty() || !what.original->normals.empty()) {
        file.normals = {what.normals, what.render->cornerRenderVertices};
    }
    if (!what.sourcePath.isEmpty()) {
        const QFileInfo source(what.sourcePath);
        file.sourceFolder = source.absolutePath();
        file.sourcePath = source.suffix().compare(QLatin1String("obj"), Qt::CaseInsensitive) == 0
                              ? what.sourcePath
                              : QString();
    }
    file.goOn = goOn;
    return exportObj(file, path);
}

Result<QStringList> exportTarget(const Target& target, const QString& path, NormalMode normals) {
    return writeExport(copyForExport(target, normals), path);
}

}  // namespace hitscope
