// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a session without a window, and says whether its hits make of its meshes what they made when it was
// saved.
#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QTextStream>

#include "cli/agreement.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/pipeline_argument.h"
#include "document/open_document.h"
#include "document/session_file.h"
#include "gl/context.h"
#include "session/export/export_target.h"
#include "session/session.h"

namespace hitscope::cli {

namespace {

struct ReplayOptions {
    QString sessionPath;
    QString outPath;                       ///< empty: none
    std::optional<PipelineKind> pipeline;  ///< nothing: the session's
    std::optional<std::size_t> until;      ///< hits; nothing: all
};

/// Fails where a mesh is missing; what has changed is noted.
Result<PreparedSession> prepare(const ReplayOptions& options, QTextStream& notes) {
    Result<SessionDocument> document = readSessionFile(options.sessionPath);
    if (!document) {
        return document.error();
    }
    MeshPlaces places;
    places.folder = QFileInfo(options.sessionPath).absolutePath();
    Result<PreparedSession> prepared = prepareSession(std::move(document).value(), places);
    if (!prepared) {
        return prepared;
    }
    for (const MeshTrouble& trouble : prepared.value().troubles) {
        if (trouble.kind != MeshTrouble::Kind::Changed) {
            return Error{trouble.error.what, trouble.error.where,
                         "Put it there, or beside the session as it was when that was saved."};
        }
        notes << "note: " << QString::fromStdString(trouble.error.message()) << "\n";
    }
    for (const QString& note : prepared.value().notes) {
        notes << "note: " << note << "\n";
    }
    return prepared;
}

/// Whether the positions that were saved are of the same hits, and all of them.
bool canCompare(const Session& session, const SessionDocument& document, std::size_t shown) {
    const bool keepsAll = pipelineTraits(document.simulation.pipeline).keepsAll;
    const bool isSame = document.simulation.pipeline == session.settings().pipeline();
    return !document.positions.empty() && shown == document.selection.shown.value_or(document.hits.size()) &&
           (isSame || (keepsAll && session.readBack().droppedHits() == 0));
}

Status compare(const Session& session, const SessionDocument& document, const ReplayOptions& options,
               QTextStream& out) {
    const std::size_t shown = session.hits().shown().size();
    if (!canCompare(session, document, shown)) {
        out << "the session has no positions of these hits to compare with\n";
        return Done{};
    }
    const std::vector<TargetId> differing = differingTargets(session, document);
    if (differing.empty()) {
        out << "the positions are those that were saved\n";
        return Done{};
    }
    QStringList names;
    for (const TargetId target : differing) {
        names << session.targets().find(target)->name;
    }
    const PipelineVerdict* verdict = session.readBack().verdict().of(session.settings().pipeline());
    return Error{"The positions are not those that were saved, on " +
                     names.join(QStringLiteral(", ")).toStdString() + ".",
                 options.sessionPath.toStdString(),
                 verdict != nullptr && !verdict->isExact()
                     ? "This pipeline is not exact on this renderer; try --pipeline reference."
                     : "The meshes have changed, or another renderer made the saved positions."};
}

Status replay(const ReplayOptions& options) {
    QTextStream out(stdout);
    QTextStream notes(stderr);
    Result<PreparedSession> prepared = prepare(options, notes);
    if (!prepared) {
        return prepared.error();
    }
    const SessionDocument& document = prepared.value().document;
    if (options.until && *options.until > document.hits.size()) {
        return Error{"The session has only " + std::to_string(document.hits.size()) + " hits.",
                     options.sessionPath.toStdString(), "Choose another --until."};
    }
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    Session session;
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
    if (!gpu) {
        return gpu.error();
    }
    restoreSession(session, prepared.value());
    session.hits().show(options.until);
    if (Status used =
            usePipeline(session, *gpu.value(), options.pipeline.value_or(document.simulation.pipeline));
        !used) {
        return used;
    }
    out << session.hits().shown().size() << " of " << document.hits.size() << " hits on "
        << session.targets().size() << " targets\n"
        << fingerprintLines(session);
    if (!options.outPath.isEmpty() && !session.targets().empty()) {
        const Target& exported = mostChangedTarget(session);
        if (Status status = exportNamed(session, exported, options.outPath, NormalMode::True); !status) {
            return status;
        }
        out << "In " << QDir::toNativeSeparators(options.outPath) << ": " << exported.name << "\n";
    }
    return compare(session, document, options, out);
}

}  // namespace

int replayCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Opens a session and applies its hits again, with no display. Prints a fingerprint each of the hits\n"
        "and of the positions. The exit status is 1 where these are not the positions that were saved."));
    parser.addHelpOption();
    const QCommandLineOption pipeline(QStringLiteral("pipeline"),
                                      QStringLiteral("Who applies the hits: %1. Default: the session's.")
                                          .arg(pipelineWords().join(QStringLiteral(", "))),
                                      QStringLiteral("name"));
    const QCommandLineOption until(QStringLiteral("until"), QStringLiteral("Only the first so many hits."),
                                   QStringLiteral("number"));
    const QCommandLineOption out(QStringLiteral("out"),
                                 QStringLiteral("OBJ file for the target that changed most."),
                                 QStringLiteral("file"));
    parser.addOptions({pipeline, until, out});
    parser.addPositionalArgument(QStringLiteral("session"), QStringLiteral("Session file (.hitscope)."));
    if (const std::optional<int> status = parse(parser, QStringLiteral("replay"), arguments)) {
        return *status;
    }
    ReplayOptions options;
    if (parser.positionalArguments().size() != 1) {
        return wrongUsage(QStringLiteral("replay takes one session file."));
    }
    options.sessionPath = parser.positionalArguments().constFirst();
    options.outPath = parser.value(out);
    options.pipeline = pipelineNamed(parser.value(pipeline));
    if (parser.isSet(pipeline) && !options.pipeline) {
        return wrongUsage(
            QStringLiteral("--pipeline takes one of %1.").arg(pipelineWords().join(QStringLiteral(", "))));
    }
    if (parser.isSet(until)) {
        bool isNumber = false;
        options.until = parser.value(until).toUInt(&isNumber);
        if (!isNumber) {
            return wrongUsage(QStringLiteral("--until takes a whole number, 0 or more."));
        }
    }
    return finish(replay(options));
}

}  // namespace hitscope::cli
