// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/source_mesh.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "document/document_fields.h"
#include "document/field_writer.h"
#include "io/import.h"
#include "io/read_picture.h"
#include "mesh/missing_textures.h"
#include "session/primitive_target.h"

namespace hitscope {

namespace {

/// What tells meshes apart: all of a target that its mesh is made from, as a file has it.
std::string keyOf(const SavedTarget& target) {
    SavedTarget mesh;
    mesh.id = TargetId{1};
    mesh.source = target.source;
    mesh.placement = target.placement;
    mesh.steps = target.steps;
    mesh.textures = target.textures;
    std::string key;
    FieldWriter(key, FieldWriter::Layout::Compact).whole({}, mesh);
    return key;
}

/// As place() did it, in every bit.
void placeAgain(MeshData& mesh, const Placement& placement) {
    if (placement.isIdentity() && mesh.placement.isIdentity()) {
        return;
    }
    if (mesh.filePositions.empty()) {
        mesh.filePositions.assign(mesh.positions.begin(), mesh.positions.end());
    }
    mesh.placement = placement;
    std::transform(
        mesh.filePositions.begin(), mesh.filePositions.end(), mesh.positions.begin(),
        [&placement](const glm::dvec3& position) { return glm::vec3(placement.toLocal(position)); });
}

Error missing(const QString& path) {
    return {"The mesh of this session is not there.", path.toStdString(),
            "Choose where it is now, or leave its targets out."};
}

Error changed(const QString& path) {
    return {"The mesh has changed since the session was saved; its hits are applied to it as it is now.",
            path.toStdString(), "Look whether they are still where they should be."};
}

}  // namespace

std::optional<MeshFile> findMesh(const SavedTarget& target, const MeshPlaces& places) {
    const auto* wanted = std::get_if<MeshFile>(&target.source.mesh);
    if (wanted == nullptr) {
        return std::nullopt;
    }
    const MeshFile& file = *wanted;
    QStringList paths;
    if (const auto chosen = places.found.find(file.path); chosen != places.found.end()) {
        paths << chosen->second;
    }
    if (!places.folder.isEmpty() && !target.source.relativePath.isEmpty()) {
        paths << QDir::cleanPath(QDir(places.folder).absoluteFilePath(target.source.relativePath));
    }
    paths << file.path;
    for (const QString& folder : places.others) {
        paths << QDir(folder).absoluteFilePath(QFileInfo(file.path).fileName());
    }
    paths.removeDuplicates();
    std::optional<MeshFile> first;
    for (const QString& path : paths) {
        if (!QDir::isAbsolutePath(path) || !QFileInfo(path).isFile()) {
            continue;
        }
        MeshFile there = meshFileAt(path);
        if (there.sha256 == file.sha256) {
            return there;
        }
        first = first.value_or(std::move(there));
    }
    return first;
}

const TargetPlan* SourceMeshes::planOf(const SavedTarget& target) {
    const std::string key = keyOf(target);
    auto made = m_made.find(key);
    if (made == m_made.end()) {
        const std::size_t first = m_troubles.size();
        std::optional<TargetPlan> plan = make(target);
        made = m_made.emplace(key, Made{std::move(plan), first, m_troubles.size()}).first;
    } else {
        for (std::size_t i = made->second.firstTrouble; i < made->second.endOfTroubles; ++i) {
            m_troubles[i].targets.push_back(target.id);
        }
    }
    return made->second.plan ? &*made->second.plan : nullptr;
}

std::optional<TargetPlan> SourceMeshes::make(const SavedTarget& target) {
    if (const auto* file = std::get_if<MeshFile>(&target.source.mesh)) {
        return import(target, *file);
    }
    if (std::holds_alternative<std::monostate>(target.source.mesh)) {
        note(target, MeshTrouble::Kind::NotKnown,
             {"The session does not say what this target was made from.", target.name.toStdString(),
              "Its hits can only be opened without it."});
        return std::nullopt;
    }
    const auto* primitive = std::get_if<Primitive>(&target.source.mesh);
    TargetPlan plan = primitive != nullptr ? planPrimitive(*primitive)
                                           : planBuiltIn(std::get<BuiltInMesh>(target.source.mesh));
    if (!target.placement.isIdentity() || !target.steps.empty()) {
        MeshData mesh = *plan.shape.mesh;
        placeAgain(mesh, target.placement);
        MeshSteps steps;
        std::optional<MeshData> made = stepped(target, std::move(mesh), steps);
        if (!made) {
            return std::nullopt;
        }
        // As a mesh that was placed: it collides with its triangles.
        plan = planMesh(prepareMesh(std::move(*made)), target.source.mesh, std::move(steps));
    }
    return plan;
}

std::optional<MeshData> SourceMeshes::stepped(const SavedTarget& target, MeshData mesh, MeshSteps& steps) {
    for (const MeshStep& step : target.steps) {
        steps.push_back(std::make_shared<const MeshStep>(step));
    }
    if (!target.placement.isIdentity()) {
        if (const Status valid = validate(mesh); !valid) {  // moved or scaled to infinity
            note(target, MeshTrouble::Kind::Missing, valid.error());
            return std::nullopt;
        }
    }
    if (steps.empty()) {
        return mesh;
    }
    Result<MeshData> made = withSteps(std::move(mesh), steps, [this](double share) {
        if (m_control.progress) {
            m_control.progress(share,
                               QCoreApplication::translate("hitscope::OpenDocument", "Refining the mesh"));
        }
        return !m_control.isCancelled();
    });
    if (!made) {
        note(target, MeshTrouble::Kind::Missing, made.error());
        return std::nullopt;
    }
    return std::move(made).value();
}

std::optional<TargetPlan> SourceMeshes::import(const SavedTarget& target, const MeshFile& file) {
    const std::optional<MeshFile> found = findMesh(target, m_places);
    if (!found) {
        note(target, MeshTrouble::Kind::Missing, missing(file.path));
        return std::nullopt;
    }
    Result<ImportedMesh> imported = importFile(found->path);
    if (!imported) {
        note(target, MeshTrouble::Kind::Missing, imported.error());
        return std::nullopt;
    }
    if (!file.sha256.empty() && found->sha256 != file.sha256) {
        note(target, MeshTrouble::Kind::Changed, changed(found->path));
    }
    m_notes += imported.value().notes;
    MeshData mesh = std::move(imported.value().mesh);
    placeAgain(mesh, target.placement);
    std::vector<LocatedTexture> textures = addTextures(target, mesh);
    MeshSteps steps;
    std::optional<MeshData> made = stepped(target, std::move(mesh), steps);
    if (!made) {
        return std::nullopt;
    }
    TargetPlan plan = planMesh(prepareMesh(std::move(*made)), *found, std::move(steps));
    plan.textures = std::move(textures);
    return plan;
}

/// As importMesh(), and with an end where that is asked for.
Result<ImportedMesh> SourceMeshes::importFile(const QString& path) const {
    constexpr int kLookEvery = 50;  // milliseconds
    std::optional<Result<ImportedMesh>> result;
    QEventLoop loop;
    MeshImport import(path);
    QObject::connect(&import, &MeshImport::finished, &loop,
                     [&](const std::shared_ptr<ImportedMesh>& imported) {
                         result.emplace(std::move(*imported));
                         loop.quit();
                     });
    QObject::connect(&import, &MeshImport::failed, &loop, [&](const Error& error) {
        result.emplace(error);
        loop.quit();
    });
    QObject::connect(&import, &MeshImport::progressed, &loop, [&](double fraction, const QString& doing) {
        if (m_control.progress) {
            m_control.progress(fraction, doing);
        }
    });
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (m_control.isCancelled()) {
            import.cancel();
        }
    });
    look.start(kLookEvery);
    import.start();
    if (!result) {
        loop.exec();
    }
    return std::move(*result);
}

void SourceMeshes::note(const SavedTarget& target, MeshTrouble::Kind kind, const Error& error) {
    const auto* file = std::get_if<MeshFile>(&target.source.mesh);
    m_troubles.push_back({kind, file != nullptr ? file->path : QString(), {target.id}, 0, error});
}

/// Beside the session file if it is there, else where it was.
QString SourceMeshes::placeOf(const LocatedTexture& texture) const {
    if (!m_places.folder.isEmpty() && !texture.relativePath.isEmpty()) {
        const QString near = QDir::cleanPath(QDir(m_places.folder).absoluteFilePath(texture.relativePath));
        if (QFileInfo(near).isFile()) {
            return near;
        }
    }
    return texture.path;
}

std::vector<LocatedTexture> SourceMeshes::addTextures(const SavedTarget& target, MeshData& mesh) {
    std::vector<LocatedTexture> located;
    for (const LocatedTexture& texture : target.textures) {
        located.push_back({texture.name, placeOf(texture)});
        const std::vector<std::string> missing = missingTextures(mesh);
        if (std::find(missing.begin(), missing.end(), texture.name) == missing.end()) {
            continue;  // the mesh file finds it by itself now
        }
        if (Result<Image> image = readPicture(located.back().path)) {
            mesh = withTexture(std::move(mesh), texture.name, std::move(image).value());
        } else {
            m_notes << QString::fromStdString(image.error().message());
        }
    }
    return located;
}

}  // namespace hitscope
