// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/export_obj.h"

#include <QFileInfo>
#include <new>

#include "io/export_files.h"
#include "io/format_mtl.h"

namespace hitscope {
namespace {

Status checkLengths(const ObjExport& what) {
    const bool fits = what.mesh && what.positions.size() == what.mesh->positions.size() &&
                      (what.normals.empty() || what.normals.size() == what.mesh->cornerVertices.size());
    return fits ? Status(Done{})
                : Status(Error{"The deformed mesh and its original do not have the same vertices.", {}, {}});
}

/// Beside the OBJ, under its name; a name without blanks, because some readers take a blank for the end. An
/// MTL of that name is replaced only if there is an OBJ as well, which the person agreed to replace.
QString libraryPath(const QFileInfo& obj, const QByteArray& content) {
    QString name = obj.completeBaseName() + QStringLiteral(".mtl");
    name.replace(QLatin1Char(' '), QLatin1Char('_'));
    return obj.exists() ? obj.absolutePath() + QLatin1Char('/') + name
                        : freePath(obj.absolutePath(), name, content);
}

/// Gives the library's name for the mtllib line. The library is written before the OBJ, so that an OBJ never
/// refers to one that is not there.
Result<std::string> exportMaterials(const ObjExport& what, const QFileInfo& obj) {
    if (what.mesh->materials.empty()) {
        return std::string();
    }
    const Result<std::vector<std::string>> textures =
        placeTextures(*what.mesh, what.sourceFolder, obj.absolutePath(), obj.completeBaseName());
    if (!textures) {
        return textures.error();
    }
    const std::string content = formatMtl(*what.mesh, textures.value());
    const QString path = libraryPath(obj, QByteArray::fromStdString(content));
    if (const Status written = writeWhole(path, content); !written) {
        return written.error();
    }
    return QFileInfo(path).fileName().toStdString();
}

}  // namespace

Status exportObj(const ObjExport& what, const QString& path) {
    if (Status fits = checkLengths(what); !fits) {
        return fits;
    }
    try {
        const Result<std::string> library = exportMaterials(what, QFileInfo(path));
        if (!library) {
            return library.error();
        }
        return writeWhole(path, formatObj(what, library.value()));
    } catch (const std::bad_alloc&) {
        return Error{"There is not enough memory to write the mesh.", path.toStdString(),
                     "Close other programs."};
    }
}

}  // namespace hitscope
