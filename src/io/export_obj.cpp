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

/// The MTL that goes with an OBJ. Without a path: none.
struct Library {
    QString path;
    std::string content;
};

Result<Library> prepareMaterials(const ObjExport& what, const QFileInfo& obj) {
    if (what.mesh->materials.empty()) {
        return Library();
    }
    const Result<std::vector<PlacedTextures>> textures =
        placeTextures(*what.mesh, what.sourceFolder, obj.absolutePath(), obj.completeBaseName());
    if (!textures) {
        return textures.error();
    }
    Library library;
    library.content = formatMtl(*what.mesh, textures.value());
    library.path = libraryPath(obj, QByteArray::fromStdString(library.content));
    return library;
}

}  // namespace

Status exportObj(const ObjExport& what, const QString& path) {
    if (Status fits = checkLengths(what); !fits) {
        return fits;
    }
    try {
        const Result<Library> library = prepareMaterials(what, QFileInfo(path));
        if (!library) {
            return library.error();
        }
        const QString& libraryPath = library.value().path;
        const std::string text = formatObj(what, QFileInfo(libraryPath).fileName().toStdString());
        if (text.empty()) {
            return Error{"The export was cancelled.", path.toStdString(), "The file is as it was."};
        }
        // The library first, so that an OBJ never refers to one that is not there.
        if (!libraryPath.isEmpty()) {
            if (Status written = writeWhole(libraryPath, library.value().content); !written) {
                return written;
            }
        }
        return writeWhole(path, text);
    } catch (const std::bad_alloc&) {
        return Error{"There is not enough memory to write the mesh.", path.toStdString(),
                     "Close other programs."};
    }
}

}  // namespace hitscope
