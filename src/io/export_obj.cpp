// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/export_obj.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <new>

#include "io/export_files.h"
#include "io/format_mtl.h"
#include "io/writers/coordinate_check.h"
#include "io/writers/source_obj.h"

namespace hitscope {
namespace {

Status checkLengths(const ObjExport& what) {
    const bool fits = what.mesh && what.positions.size() == what.mesh->positions.size() &&
                      (what.normals.empty() || what.normals.size() == what.mesh->cornerVertices.size());
    return fits ? Status(Done{})
                : Status(Error{"The deformed mesh and its original do not have the same vertices.", {}, {}});
}

ExportPlace placeOf(const ObjExport& what, const QFileInfo& obj) {
    return {what.sourceFolder, obj.absolutePath(), obj.completeBaseName()};
}

/// What the OBJ's mtllib lines say, once what they refer to is staged.
Result<std::vector<std::string>> stageMaterials(const ObjExport& what, const QFileInfo& obj,
                                                StagedFiles& staged) {
    const ExportPlace place = placeOf(what, obj);
    MaterialFiles files(*what.mesh, place, staged);
    if (!what.sourceFolder.isEmpty() && !what.mesh->materialLibraries.empty()) {
        return files.placeLibraries();
    }
    if (what.mesh->materials.empty()) {
        return std::vector<std::string>();
    }
    const Result<std::vector<PlacedTextures>> textures = files.placeTextures();
    if (!textures) {
        return textures.error();
    }
    const std::string text = formatMtl(*what.mesh, textures.value());
    // Some readers take a blank for the name's end.
    QString name = obj.completeBaseName() + QStringLiteral(".mtl");
    name.replace(QLatin1Char(' '), QLatin1Char('_'));
    const QString path = files.freePath(name, QByteArray::fromStdString(text));
    if (!QFileInfo::exists(path)) {
        if (const Status added = staged.add(path, text, StagedFiles::Existing::Keep); !added) {
            return added.error();
        }
    }
    return std::vector<std::string>{QFileInfo(path).fileName().toStdString()};
}

QStringList noteOfOthers(const StagedFiles& staged, const ObjExport& what, const QString& path) {
    return what.isAlone ? QStringList() : staged.noteOfOthers(path);
}

/// Notes, or why nothing could be staged, or what commit() says.
Result<QStringList> writeAnew(const ObjExport& what, const QString& path) {
    StagedFiles staged(what.beforeStep);
    const Result<std::vector<std::string>> libraries = stageMaterials(what, QFileInfo(path), staged);
    if (!libraries) {
        return libraries.error();
    }
    const std::string text = formatObj(what, libraries.value());
    if (text.empty()) {
        return Error{"The export was cancelled.", path.toStdString(), "The file is as it was."};
    }
    // Last, so that an OBJ never refers to files that are not there.
    Status written = staged.add(path, text, StagedFiles::Existing::Replace);
    if (written) {
        written = staged.commit();
    }
    return written ? Result<QStringList>(noteOfOthers(staged, what, path))
                   : Result<QStringList>(written.error());
}

Result<SourceCopy> writeFromSource(const ObjExport& what, const QString& path, QStringList& notes) {
    StagedFiles staged(what.beforeStep);
    const ExportPlace place = placeOf(what, QFileInfo(path));
    MaterialFiles materials(*what.mesh, place, staged);
    Result<SourceCopy> copied = copyWithChanges(what, path, materials, staged);
    if (copied && copied.value() == SourceCopy::Written) {
        if (const Status named = staged.commit(); !named) {
            return named.error();
        }
        notes += noteOfOthers(staged, what, path);
    }
    return copied;
}

Result<QStringList> write(const ObjExport& what, const QString& path) {
    QStringList notes;
    if (!what.sourcePath.isEmpty() && what.inFile().sourceHash != 0) {
        const Result<SourceCopy> copied = writeFromSource(what, path, notes);
        if (!copied || copied.value() == SourceCopy::Written) {
            return copied ? Result<QStringList>(notes) : Result<QStringList>(copied.error());
        }
        const QString name = QFileInfo(what.sourcePath).fileName();
        notes +=
            (copied.value() == SourceCopy::NotThere
                 ? QCoreApplication::translate("ExportObj", "“%1” is not there any more")
                 : QCoreApplication::translate("ExportObj", "“%1” has changed since it was opened"))
                .arg(name) +
            QCoreApplication::translate(
                "ExportObj", ": the mesh was written anew, without the comments and layout of its file.");
    }
    const Result<QStringList> written = writeAnew(what, path);
    return written ? Result<QStringList>(notes + written.value()) : written;
}

}  // namespace

Result<QStringList> exportObj(const ObjExport& what, const QString& path) {
    if (Status fits = checkLengths(what); !fits) {
        return fits.error();
    }
    if (Status fits = checkCoordinates(*what.mesh, what.positions, path); !fits) {
        return fits.error();
    }
    try {
        return write(what, path);
    } catch (const std::bad_alloc&) {
        return Error{"There is not enough memory to write the mesh.", path.toStdString(),
                     "Close other programs."};
    }
}

}  // namespace hitscope
