// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/source_obj.h"

#include <fcntl.h>

#include <QFile>
#include <QScopeGuard>
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <functional>
#include <memory>
#include <vector>

#include "core/give_up.h"
#include "core/parallel.h"
#include "io/descriptor.h"
#include "io/writers/file_coordinate.h"
#include "io/writers/obj_index_cache.h"
#include "io/writers/obj_patcher.h"
#include "io/writers/source_writer.h"

namespace hitscope {
namespace {

Error givenUp(const QString& path) {
    return {"The export was cancelled.", path.toStdString(), "The file is as it was."};
}

bool fits(const ObjIndex& index, const MeshData& mesh) {
    std::size_t vertices = 0;
    std::size_t normals = 0;
    std::size_t faces = 0;
    std::size_t libraries = 0;
    for (const SourcePart& part : index.parts) {
        vertices += part.vertices;
        normals += part.normals;
        faces += part.faces;
        libraries += part.libraries;
    }
    return index.hash == mesh.sourceHash && vertices == mesh.positions.size() &&
           normals == mesh.normals.size() && faces == mesh.faceCount() &&
           libraries == mesh.materialLibraries.size();
}

/// Vertices with a coordinate that is another number than the file's, as movedVertices() says.
std::vector<std::uint8_t> changedVertices(const ObjExport& what) {
    if (!what.asRead) {
        return movedVertices(*what.mesh, what.positions);
    }
    std::vector<std::uint8_t> changed(what.positions.size());
    for (std::size_t v = 0; v < changed.size(); ++v) {
        mayGiveUp(v);
        for (int axis = 0; axis < 3; ++axis) {
            if (!isInFile(*what.asRead, v, what.positions[v], axis)) {
                changed[v] = 1;
            }
        }
    }
    return changed;
}

/// Where all turned, each corner may have another normal.
NormalPlan changedNormals(const ObjExport& what, const std::vector<std::uint8_t>& changed) {
    if (!what.asRead) {
        return planNormals(*what.mesh, changed, what.normals, what.allNormals);
    }
    const bool isTurned = !std::ranges::equal(what.asRead->normals, what.mesh->normals);
    const std::vector<std::uint8_t> moved =
        isTurned ? std::vector<std::uint8_t>(changed.size(), 1) : movedVertices(*what.mesh, what.positions);
    return planNormals(*what.asRead, moved, what.normals, what.allNormals);
}

/// Plans the normals while what does not depend on them is written.
Status stageWhilePlanning(SourceWriter& writer, const QString& path, StagedFiles& staged,
                          const std::function<NormalPlan()>& plan) {
    std::atomic<bool> isOver = false;
    Status added = Done{};
    const std::function<bool()> isWanted = [&isOver] { return !isOver; };
    bothAtOnce(
        [&] {
            const GiveUpScope watched(isWanted, GiveUpScope::Asked::Anywhere);
            try {
                writer.takeNormals(plan());
            } catch (const GivenUp&) {
            } catch (...) {
                writer.fail(ENOMEM);
                throw;
            }
        },
        [&] {
            const auto end = qScopeGuard([&isOver] { isOver = true; });
            added = staged.add(path, [&writer](int to) { return writer.write(to); });
        });
    return added;
}

}  // namespace

Result<SourceCopy> copyWithChanges(const ObjExport& what, const QString& path, MaterialFiles& materials,
                                   StagedFiles& staged) {
    bool isGivenUp = false;
    const ExportGoOn goOn = [&what, &isGivenUp](ExportStep step, double share) {
        isGivenUp = isGivenUp || (what.goOn && !what.goOn(step, share));
        return !isGivenUp;
    };
    // Not blocking: a pipe that took the file's place must not hold us for ever.
    const Descriptor source(
        ::open(QFile::encodeName(what.sourcePath).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!source.isOpen()) {
        return SourceCopy::NotThere;
    }
    const FileStamp before(source.get());
    const std::function<bool(double)> reading = within(goOn, ExportStep::Reading);
    ObjFaces faces = ObjFaces::AllLines;
    std::shared_ptr<const ObjIndex> index = indexedObj(source.get(), faces, reading);
    if (index && index->hash == what.inFile().sourceHash && !fits(*index, what.inFile())) {
        faces = ObjFaces::OfThreeCorners;  // the reader left some out
        index = indexedObj(source.get(), faces, reading);
    }
    if (isGivenUp) {
        return givenUp(path);
    }
    if (!index || !fits(*index, what.inFile())) {
        return index ? SourceCopy::Changed : SourceCopy::NotThere;
    }
    const Result<std::map<std::size_t, std::string>> libraries = materials.placeLibraryLines();
    if (!libraries) {
        return libraries.error();
    }
    goOn(ExportStep::Preparing, 0.0);
    const std::vector<std::uint8_t> changed = changedVertices(what);
    const ObjChanges changes{what.inFile(), what.positions, changed, libraries.value(),
                             what.asRead != nullptr};
    ObjPatcher patcher(changes, *index, faces);
    const std::function<bool(double)> writing = within(goOn, ExportStep::Writing);
    SourceWriter writer(*index, patcher, source.get(), writing);
    const Status added =
        stageWhilePlanning(writer, path, staged, [&] { return changedNormals(what, changed); });
    if (isGivenUp) {
        return givenUp(path);
    }
    if (writer.couldNotRead() || !(FileStamp(source.get()) == before)) {
        return SourceCopy::Changed;  // while it was copied
    }
    return added ? Result<SourceCopy>(SourceCopy::Written) : Result<SourceCopy>(added.error());
}

}  // namespace hitscope
