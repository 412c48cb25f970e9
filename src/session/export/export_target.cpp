// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/export/export_target.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <atomic>
#include <glm/gtc/quaternion.hpp>
#include <new>
#include <optional>

#include "core/give_up.h"
#include "deform/effects.h"
#include "io/check/written_check.h"
#include "io/export_obj.h"
#include "io/writers/merge_targets.h"
#include "io/writers/morph_steps.h"
#include "session/session.h"

namespace hitscope {

namespace {

Error givenUp(const QString& path) {
    return {"The export was cancelled.", path.toStdString(), "The file is as it was."};
}

/// told: with the share of the hits that are counted.
std::vector<std::uint32_t> hitsPerVertex(const TargetExport& target, std::span<const Hit> hits,
                                         const std::function<void(double)>& told) {
    constexpr std::size_t kParts = 50;
    std::vector<Hit> own;
    std::copy_if(hits.begin(), hits.end(), std::back_inserter(own),
                 [&target](const Hit& hit) { return hit.enabled && hit.target == target.id; });
    const std::atomic<bool> stop = false;
    TargetEffects effects(target.render);
    const std::size_t part = own.size() / kParts + 1;
    for (std::size_t first = 0; first < own.size(); first += part) {
        const std::span<const Hit> now = std::span(own).first(std::min(first + part, own.size()));
        const TargetHitsEdit edit{
            .target = target.id, .first = first, .before = {}, .after = {now.begin() + first, now.end()}};
        effects.follow({&edit, 1}, now, stop);
        told(static_cast<double>(now.size()) / static_cast<double>(own.size()));
    }
    return {effects.counts().begin(), effects.counts().end()};
}

/// Everything that a writer is given, and what that lives on.
class Gathered {
public:
    explicit Gathered(const SceneExport& what) : m_what(what) {}

    /// An error: given up, or too large for one mesh.
    Status gather(const ExportGoOn& goOn, const QString& path);
    [[nodiscard]] const MeshExport& mesh() const { return m_mesh; }  ///< with the writer's goOn
    /// Without a copy for each corner where there is one target in its file's coordinates.
    [[nodiscard]] CornerNormalView normals() const;
    [[nodiscard]] const QStringList& notes() const { return m_notes; }

private:
    struct One {
        std::vector<glm::vec3> normals;  // one a corner
        std::vector<std::uint32_t> hits;
    };
    void countHits(const ExportGoOn& goOn);
    void gatherNormals(const ExportGoOn& goOn);
    [[nodiscard]] bool hasNormals(const TargetExport& target) const;
    [[nodiscard]] bool stepsLeadToShown() const;
    void noteSteps(const TargetExport& target);
    void noteSource(const TargetExport& target);
    [[nodiscard]] PlacedTarget placed(std::size_t t) const;
    void take(MergedTargets merged);
    Status gatherOne();
    Status merge();

    const SceneExport& m_what;
    std::vector<One> m_targets;
    std::vector<std::vector<MorphStep>> m_steps;  // of each target
    std::optional<MergedTargets> m_merged;
    MeshExport m_mesh;
    QStringList m_notes;
};

/// A file that has no normals gets none; a mesh of our own has them.
bool Gathered::hasNormals(const TargetExport& target) const {
    return target.sourcePath.isEmpty() || !target.original->normals.empty() || m_what.options.allNormals;
}

CornerNormalView Gathered::normals() const {
    const TargetExport& first = m_what.targets.front();
    if (m_merged) {
        return {m_mesh.normals, {}};
    }
    return hasNormals(first) ? CornerNormalView{*first.normals, first.render->cornerRenderVertices}
                             : CornerNormalView();
}

bool Gathered::stepsLeadToShown() const {
    for (std::size_t t = 0; t < m_what.targets.size(); ++t) {
        const TargetExport& target = m_what.targets[t];
        PageVector<glm::vec3> end = target.original->positions;
        for (const MorphStep& step : m_steps[t]) {
            for (const MovedVertex& moved : step.moved) {
                mayGiveUp(moved.vertex);
                end[moved.vertex] = moved.position;
            }
        }
        if (!std::ranges::equal(end, target.positions)) {
            return false;
        }
    }
    return true;
}

void Gathered::countHits(const ExportGoOn& goOn) {
    const auto count = static_cast<double>(m_what.targets.size());
    for (std::size_t t = 0; t < m_what.targets.size(); ++t) {
        m_targets[t].hits = hitsPerVertex(m_what.targets[t], m_what.hits, [&](double share) {
            if (goOn && !goOn(ExportStep::Counting, (static_cast<double>(t) + share) / count)) {
                throw GivenUp{};
            }
        });
    }
}

void Gathered::gatherNormals(const ExportGoOn& goOn) {
    for (std::size_t t = 0; t < m_what.targets.size(); ++t) {
        const TargetExport& target = m_what.targets[t];
        if (!hasNormals(target) || !(m_what.isPlaced() || m_what.options.format != ExportFormat::Obj)) {
            continue;
        }
        tellPart(goOn, ExportStep::Gathering, t * kStepsBetweenLooks,
                 m_what.targets.size() * kStepsBetweenLooks);
        std::vector<glm::vec3>& normals = m_targets[t].normals;
        normals.reserve(target.render->cornerRenderVertices.size());
        for (const std::uint32_t vertex : target.render->cornerRenderVertices) {
            mayGiveUp(normals.size());
            normals.push_back((*target.normals)[vertex]);
        }
    }
}

Status Gathered::gather(const ExportGoOn& goOn, const QString& path) {
    m_targets.resize(m_what.targets.size());
    if (m_what.needsHits()) {
        countHits(goOn);
    }
    m_steps.resize(m_what.targets.size());
    if (m_what.hasSteps()) {
        std::vector<MorphedTarget> morphed;
        for (const TargetExport& target : m_what.targets) {
            morphed.push_back({target.id, target.render});
        }
        auto steps = morphSteps(m_what.hits, morphed, {m_what.options.stepOf, m_what.options.steps},
                                within(goOn, ExportStep::Replaying));
        if (!steps) {
            return givenUp(path);
        }
        m_steps = std::move(*steps);
        if (!stepsLeadToShown()) {
            m_notes += QCoreApplication::translate(
                "Export",
                "The animation ends at what the reference makes of the hits; what is shown differs.");
        }
    }
    gatherNormals(goOn);
    Status gathered = m_what.isMerged() ? merge() : gatherOne();
    m_mesh.goOn = goOn;
    m_mesh.beforeStep = m_what.beforeStep;
    return gathered;
}

Status Gathered::gatherOne() {
    const TargetExport& target = m_what.targets.front();
    if (m_what.options.inWorld) {
        take(placeTarget(placed(0)));
        m_mesh.asRead = target.original.get();
    } else {
        m_mesh.mesh = target.original.get();
        m_mesh.positions = target.positions;
        m_mesh.normals = m_targets.front().normals;
        m_mesh.hits = m_targets.front().hits;
        m_mesh.steps = std::move(m_steps.front());
    }
    m_mesh.sourcePath = target.sourcePath;
    noteSteps(target);
    return Done{};
}

/// A file that a mesh was refined or simplified from cannot be copied with changes: it is another mesh.
void Gathered::noteSteps(const TargetExport& target) {
    const MeshData& mesh = *target.original;
    if (mesh.isAsRead()) {
        return;
    }
    const auto added = static_cast<std::size_t>(
        std::count(mesh.sourceVertices.begin(), mesh.sourceVertices.end(), kNoIndex));
    m_notes +=
        QCoreApplication::translate(
            "Export", "%1 is no longer the mesh of its file: it was written in full. New vertices: %2 of %3.")
            .arg(QString::fromStdString(target.name), QLocale().toString(static_cast<qulonglong>(added)),
                 QLocale().toString(static_cast<qulonglong>(mesh.vertexCount())));
}

/// What a copy of the source with changes would keep, and a mesh written anew has not.
void Gathered::noteSource(const TargetExport& target) {
    const ExportFormat source = exportFormatOf(target.sourcePath).value_or(ExportFormat::Csv);
    const bool isPly =
        m_what.options.format == ExportFormat::Ply || m_what.options.format == ExportFormat::PlyAscii;
    if (target.original->isAsRead() &&
        ((m_what.options.format == ExportFormat::Obj && source == ExportFormat::Obj) ||
         (isPly && source == ExportFormat::Ply))) {
        m_notes +=
            QCoreApplication::translate(
                "Export",
                "%1 was written anew: comments, and what is not shown of its file or its materials, are "
                "left out. One target in a file of its own keeps them.")
                .arg(QString::fromStdString(target.name));
    }
}

PlacedTarget Gathered::placed(std::size_t t) const {
    const TargetExport& target = m_what.targets[t];
    PlacedTarget one;
    one.mesh = target.original.get();
    one.positions = target.positions;
    one.normals = m_targets[t].normals;
    one.hits = m_targets[t].hits;
    one.steps = m_steps[t];
    one.transform = glm::dmat4(glm::dquat(target.transform.rotation));
    one.transform[3] = glm::dvec4(glm::dvec3(target.transform.position), 1.0);
    one.name = target.name;
    one.sourcePath = target.sourcePath;
    return one;
}

void Gathered::take(MergedTargets merged) {
    m_merged = std::move(merged);
    m_notes += m_merged->notes;
    std::vector<MorphStep> steps = std::move(m_merged->steps);  // what() copies them
    m_mesh = m_merged->what();
    m_mesh.steps = std::move(steps);
}

Status Gathered::merge() {
    std::vector<PlacedTarget> targets;
    for (std::size_t t = 0; t < m_what.targets.size(); ++t) {
        targets.push_back(placed(t));
        noteSteps(m_what.targets[t]);
        noteSource(m_what.targets[t]);
    }
    Result<MergedTargets> merged = mergeTargets(targets);
    if (!merged) {
        return merged.error();
    }
    take(std::move(merged.value()));
    return Done{};
}

Result<QStringList> writeObj(const MeshExport& mesh, const CornerNormalView& normals,
                             const ExportOptions& options, const QString& path) {
    ObjExport file;
    file.mesh = mesh.mesh;
    file.positions = mesh.positions;
    file.normals = normals;
    file.allNormals = options.allNormals;
    file.isAlone = options.isAlone;
    file.sourceFolder = mesh.sourceFolder;
    if (!mesh.sourcePath.isEmpty()) {
        file.sourceFolder = QFileInfo(mesh.sourcePath).absolutePath();
        const bool isSource = mesh.mesh->isAsRead() && exportFormatOf(mesh.sourcePath) == ExportFormat::Obj;
        file.sourcePath = isSource ? mesh.sourcePath : QString();
    }
    file.goOn = mesh.goOn;
    file.asRead = mesh.asRead;
    file.beforeStep = mesh.beforeStep;
    return exportObj(file, path);
}

Result<QStringList> writeMesh(const MeshExport& mesh, const CornerNormalView& normals,
                              const ExportOptions& options, const QString& path) {
    switch (options.format) {
        case ExportFormat::Obj:
            break;
        case ExportFormat::Ply:
            return exportPly(mesh, path,
                             {.encoding = PlyOptions::Encoding::Binary, .isAlone = options.isAlone});
        case ExportFormat::PlyAscii:
            return exportPly(mesh, path,
                             {.encoding = PlyOptions::Encoding::Ascii, .isAlone = options.isAlone});
        case ExportFormat::Stl:
            return exportStl(mesh, path);
        case ExportFormat::Glb:
        case ExportFormat::Gltf:
            return exportGltf(mesh, path, {.steps = options.steps > 0});
        case ExportFormat::Csv:
            return exportChangesCsv(mesh, path);
    }
    return writeObj(mesh, normals, options, path);
}

Result<ExportReport> write(const SceneExport& what, const QString& path, const ExportGoOn& goOn) {
    Gathered gathered(what);
    if (const Status status = gathered.gather(goOn, path); !status) {
        return status.error();
    }
    const MeshExport& mesh = gathered.mesh();
    const Result<QStringList> written = writeMesh(mesh, gathered.normals(), what.options, path);
    if (!written) {
        return written.error();
    }
    ExportReport report{gathered.notes() + written.value()};
    if (what.options.readBack && what.options.format != ExportFormat::Csv) {
        const bool isObj = what.options.format == ExportFormat::Obj;
        const WrittenNormals normals{isObj ? gathered.normals() : CornerNormalView{mesh.normals, {}},
                                     what.options.allNormals};
        try {
            if (const Status same = verifyWritten(path, mesh, normals, goOn); !same) {
                return same.error();
            }
            report.wasReadBack = true;
        } catch (const GivenUp&) {
            report.notes += QCoreApplication::translate(
                "Export", "The check was cancelled: the file is written, but was not read back.");
        }
    }
    return report;
}

}  // namespace

bool SceneExport::needsHits() const {
    const ExportFormat format = options.format;
    return format == ExportFormat::Ply || format == ExportFormat::PlyAscii || format == ExportFormat::Csv;
}

Result<ExportReport> writeExport(SceneExport what, const QString& path, const ExportProgress::Told& told) {
    if (const QString folder = QFileInfo(path).absolutePath(); !QFileInfo(folder).isDir()) {
        return Error{"There is no such folder.", folder.toStdString(), "Make it, or choose another one."};
    }
    try {
        for (TargetExport& target : what.targets) {
            target.complete();
        }
        ExportProgress progress(what, path, told);
        const std::function<bool()> isWanted = [&progress] { return progress.isWanted(); };
        const GiveUpScope watched(isWanted);
        return write(what, path, progress.goOn());
    } catch (const GivenUp&) {
        return givenUp(path);
    } catch (const std::bad_alloc&) {
        return Error{"There is not enough memory to write the mesh.", path.toStdString(),
                     "Close other programs."};
    }
}

Result<ExportReport> exportTarget(const Session& session, const Target& target, const QString& path,
                                  const ExportOptions& options) {
    const Target* const one = &target;
    return writeExport(copyForExport(session, {&one, 1}, options), path);
}

}  // namespace hitscope
