// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/opened_scene.h"

#include <QDir>
#include <QFileInfo>
#include <utility>

#include "cli/agreement.h"
#include "cli/outputs.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "document/document_json.h"
#include "document/session_file.h"
#include "io/import.h"
#include "io/placement_text.h"

namespace hitscope::cli {

bool namesSession(const QString& path) {
    return isStandardStream(path) || path.endsWith(QLatin1String(kSessionSuffix), Qt::CaseInsensitive);
}

Result<PreparedSession> prepareFrom(const QString& path) {
    const auto read = [&path]() -> Result<SessionDocument> {
        if (!isStandardStream(path)) {
            return readSessionFile(path);
        }
        const Result<QByteArray> bytes = readAllOf(path, qint64{1} << 31);
        if (!bytes) {
            return bytes.error();
        }
        Result<SessionDocument> parsed = readDocument(bytes.value());
        if (!parsed) {
            Error error = parsed.error();
            error.where = "standard input" + (error.where.empty() ? "" : ", " + error.where);
            error.advice = "The standard input takes a session; name the file of a mesh.";
            return error;
        }
        for (std::string& place : parsed.value().notKnown) {
            place = "standard input, " + place;
        }
        return parsed;
    };
    Result<SessionDocument> document = read();
    if (!document) {
        return document.error();
    }
    MeshPlaces places;
    places.folder = isStandardStream(path) ? QDir::currentPath() : QFileInfo(path).absolutePath();
    Result<PreparedSession> prepared = prepareSession(std::move(document).value(), places);
    if (!prepared) {
        return prepared;
    }
    for (const MeshTrouble& trouble : prepared.value().troubles) {
        if (trouble.kind != MeshTrouble::Kind::Changed) {
            return Error{trouble.error.what, trouble.error.where,
                         "Put it there, or beside the session as it was when that was saved."};
        }
        note(QStringLiteral("note: ") + QString::fromStdString(trouble.error.message()));
    }
    for (const QString& said : prepared.value().notes) {
        note(QStringLiteral("note: ") + said);
    }
    return prepared;
}

namespace {

constexpr const char* kApplying = "Applying hits";

/// Whether the positions that were saved are of the same hits, and all of them.
bool canCompare(const Session& session, const SessionDocument& document, std::size_t shown) {
    const bool keepsAll = pipelineTraits(document.simulation.pipeline).keepsAll;
    const bool isSame = document.simulation.pipeline == session.settings().pipeline();
    return !document.positions.empty() && shown == document.selection.shown.value_or(document.hits.size()) &&
           (isSame || (keepsAll && session.readBack().droppedHits() == 0));
}

/// Where a session's numbers are not those of its meshes' files. Of a mesh its import says so.
void notePlacements(const Session& session) {
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const Placement& placement = target->deformed.original().placement;
        if (!placement.isIdentity()) {
            note(QStringLiteral("note: %1: %2 Exported files have the mesh's own coordinates.")
                     .arg(target->name, placementText(placement)));
        }
    }
}

}  // namespace

Outcome OpenedScene::load(const SceneWish& wish) {
    if (wish.path.isEmpty()) {
        loadPaperRow(*m_session, kDefaultPaperRow);
        return Done{};
    }
    if (namesSession(wish.path)) {
        restoreSession(*m_session, *m_prepared);
        notePlacements(*m_session);
        return checkSources(*m_session);
    }
    Result<ImportedMesh> imported = importMesh(wish.path);
    if (!imported) {
        return imported.error();
    }
    for (const QString& said : imported.value().notes) {
        note(QStringLiteral("note: ") + said);
    }
    if (Status changed = changeCoordinates(imported.value().mesh, wish.coordinates); !changed) {
        return changed;
    }
    loadMesh(*m_session, std::move(imported.value().mesh), QFileInfo(wish.path).absoluteFilePath());
    return checkSources(*m_session);
}

Outcome OpenedScene::open(const SceneWish& wish) {
    const WaitingLine waiting(QStringLiteral("Opening"));
    if (namesSession(wish.path)) {
        Result<PreparedSession> prepared = prepareFrom(wish.path);
        if (!prepared) {
            return prepared.error();
        }
        if (wish.until && *wish.until > prepared.value().document.hits.size()) {
            return Error{"The session has only " +
                             counted(prepared.value().document.hits.size(), "hit", "hits").toStdString() +
                             '.',
                         wish.path.toStdString(), "Choose another --until."};
        }
        m_prepared = std::move(prepared).value();
    }
    m_session = std::make_unique<Session>();
    if (wish.isMeshAlone && !m_prepared) {
        return load(wish);
    }
    const PipelineKind wanted = wish.pipeline.value_or(m_prepared ? m_prepared->document.simulation.pipeline
                                                                  : PipelineKind::TransformFeedback);
    if (wanted == PipelineKind::Reference && !wish.isDrawn) {
        return openWithReference(wish);
    }
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (context) {
        return openOnGpu(wish, std::move(context).value());
    }
    Error error = context.error();
    if (wish.isDrawn) {
        return cannotDraw(std::move(error));
    }
    if (wish.pipeline || !pipelineTraits(wanted).keepsAll) {
        error.advice +=
            wish.hasPipelineOption ? " Or choose --pipeline reference, which needs no OpenGL." : "";
        return cannotDraw(std::move(error));
    }
    note(QStringLiteral("note: %1 Using the reference instead, which needs none.")
             .arg(QString::fromStdString(error.what)));
    return openWithReference(wish);
}

Outcome OpenedScene::openOnGpu(const SceneWish& wish, std::unique_ptr<gl::OffscreenContext> context) {
    m_context = std::move(context);
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(*m_session);
    if (!gpu) {
        return cannotDraw(gpu.error());
    }
    m_gpu = std::move(gpu).value();
    if (Outcome loaded = load(wish); !loaded) {
        return loaded;
    }
    if (m_prepared) {
        m_session->hits().show(wish.until);
        return use(wish.pipeline.value_or(m_prepared->document.simulation.pipeline));
    }
    return useAsked(wish.pipeline);
}

Outcome OpenedScene::openWithReference(const SceneWish& wish) {
    m_reference = std::make_unique<ReferenceScene>(*m_session);
    if (Outcome loaded = load(wish); !loaded) {
        return loaded;
    }
    if (m_prepared) {
        m_session->hits().show(wish.until);
    }
    m_session->settings().setPipeline(PipelineKind::Reference);
    m_pipeline = wish.pipeline.value_or(m_prepared ? m_prepared->document.simulation.pipeline : m_pipeline);
    return sync();
}

Outcome OpenedScene::use(PipelineKind kind) {
    const WaitingLine waiting(QString::fromLatin1(kApplying));
    const Status used = usePipeline(*m_session, *m_gpu, kind);
    m_pipeline = m_session->settings().pipeline();
    return used ? Outcome(Done{}) : cannotDraw(used.error());
}

Outcome OpenedScene::useAsked(std::optional<PipelineKind> asked) {
    const WaitingLine waiting(QString::fromLatin1(kApplying));
    const Status used = useAskedPipeline(*m_session, *m_gpu, asked);
    m_pipeline = m_session->settings().pipeline();
    return used ? Outcome(Done{}) : cannotDraw(used.error());
}

Outcome OpenedScene::sync() {
    const WaitingLine waiting(QString::fromLatin1(kApplying));
    if (m_reference) {
        m_reference->sync();
    }
    const Status synced = m_gpu ? m_gpu->sync() : Status(Done{});
    return synced ? Outcome(Done{}) : cannotDraw(synced.error());
}

std::optional<std::vector<TargetId>> OpenedScene::differing() const {
    return m_prepared && canCompare(*m_session, m_prepared->document, m_session->hits().shown().size())
               ? std::optional(differingTargets(*m_session, m_prepared->document))
               : std::nullopt;
}

QString OpenedScene::namesOf(const std::vector<TargetId>& targets) const {
    QStringList names;
    for (const TargetId target : targets) {
        names << m_session->targets().find(target)->name;
    }
    return names.join(QStringLiteral(", "));
}

void OpenedScene::noteDiffering() const {
    const std::vector<TargetId> targets = differing().value_or(std::vector<TargetId>());
    if (!targets.empty()) {
        note(QStringLiteral("note: the positions are not those that were saved, on %1; replay says more.")
                 .arg(namesOf(targets)));
    }
}

}  // namespace hitscope::cli
