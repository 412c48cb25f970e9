// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFileInfo>
#include <limits>
#include <new>

#include "io/writers/coordinate_check.h"
#include "io/writers/gltf_parts.h"
#include "io/writers/line_segments.h"

namespace hitscope {
namespace {

bool isGlb(const QString& path) {
    return QFileInfo(path).suffix().compare(QStringLiteral("glb"), Qt::CaseInsensitive) == 0;
}

/// Header, JSON and buffer one after the other.
Status stageGlb(const MeshExport& what, GltfParts& parts, const QString& path, StagedFiles& staged) {
    QByteArray json = parts.json({});
    json.append(QByteArray((4 - json.size() % 4) % 4, ' '));
    constexpr std::uint64_t kHeads = 12 + 8 + 8;
    const std::uint64_t size = kHeads + static_cast<std::uint64_t>(json.size()) + parts.document().size();
    if (size > std::numeric_limits<std::uint32_t>::max()) {
        return Error{"The mesh is too large for a GLB file, which has 4 GiB at most.", path.toStdString(),
                     "Save it as .gltf."};
    }
    return stageInPieces(what, path, staged, StagedFiles::Existing::Replace, [&](PieceWriter& out) {
        out.put("glTF");
        out.plain(std::uint32_t{2});
        out.plain(static_cast<std::uint32_t>(size));
        out.plain(static_cast<std::uint32_t>(json.size()));
        out.put("JSON");
        out.put({json.constData(), static_cast<std::size_t>(json.size())});
        out.plain(static_cast<std::uint32_t>(parts.document().size()));
        out.put(std::string_view("BIN\0", 4));
        parts.document().write(out);
    });
}

/// The JSON comes last, so that it never refers to files that are not there.
Status stageGltf(const MeshExport& what, GltfParts& parts, const QString& path, StagedFiles& staged) {
    const QFileInfo info(path);
    const QDir folder(info.absolutePath());
    QString name = info.completeBaseName() + QStringLiteral(".bin");
    for (int n = 1; QFileInfo::exists(folder.filePath(name)) ||
                    QFileInfo(folder.filePath(name)).isSymLink() || staged.holds(folder.filePath(name));
         ++n) {
        name = QStringLiteral("%1-%2.bin").arg(info.completeBaseName()).arg(n);
    }
    const Status added = stageInPieces(what, folder.filePath(name), staged, StagedFiles::Existing::Keep,
                                       [&parts](PieceWriter& out) { parts.document().write(out); });
    if (!added) {
        return added;
    }
    const QByteArray json = parts.json(name);
    return staged.add(path, {json.constData(), static_cast<std::size_t>(json.size())},
                      StagedFiles::Existing::Replace);
}

}  // namespace

Result<QStringList> exportGltf(const MeshExport& what, const QString& path, const GltfOptions& options) {
    if (const Status fits = checkLengths(what); !fits) {
        return fits.error();
    }
    if (const Status fits = checkDisplacements(what, path); !fits) {
        return fits.error();
    }
    const bool hasLoose = !lineSegments(*what.mesh).empty() || !what.mesh->points.empty();
    if (what.mesh->faceCount() == 0 && !hasLoose) {
        return Error{"The mesh has no faces, lines or points, one of which glTF needs.", path.toStdString(),
                     "Choose another format."};
    }
    try {
        StagedFiles staged(what.beforeStep);
        const QFileInfo info(path);
        const bool hasOwnFolder = what.sourceFolder.isEmpty() && !what.sourcePath.isEmpty();
        const QString folder = hasOwnFolder ? QFileInfo(what.sourcePath).absolutePath() : what.sourceFolder;
        const ExportPlace place{folder, info.absolutePath(), info.completeBaseName()};
        if (what.goOn && !what.goOn(ExportStep::Preparing, 0.0)) {
            return cancelledAt(path);
        }
        GltfParts parts(what, options, place, staged, isGlb(path));
        Status done = parts.make();
        if (done) {
            done = isGlb(path) ? stageGlb(what, parts, path, staged) : stageGltf(what, parts, path, staged);
        }
        if (done) {
            done = staged.commit();
        }
        return done ? Result<QStringList>(parts.notes() + staged.noteOfOthers(path))
                    : Result<QStringList>(done.error());
    } catch (const std::bad_alloc&) {
        return noMemoryFor(path);
    }
}

}  // namespace hitscope
