// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a session, its meshes and textures into one folder.
#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QTextStream>
#include <algorithm>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "document/collect_session.h"
#include "document/session_file.h"

namespace hitscope::cli {

namespace {

/// Where its files were found, which may be beside the session.
SessionDocument withPlaces(const PreparedSession& prepared) {
    SessionDocument document = prepared.document;
    for (const TargetState& made : prepared.scene.targets) {
        const auto target = std::find_if(document.targets.begin(), document.targets.end(),
                                         [&made](const SavedTarget& saved) { return saved.id == made.id; });
        if (target != document.targets.end()) {
            target->textures = made.textures;
            if (auto* file = std::get_if<MeshFile>(&target->source.mesh)) {
                file->path = made.sourcePath;
            }
        }
    }
    return document;
}

Error missingOf(const PreparedSession& prepared) {
    QStringList missing;
    for (const MeshTrouble& trouble : prepared.troubles) {
        if (trouble.kind != MeshTrouble::Kind::Changed) {  // collectSession() looks at these
            missing << QString::fromStdString(trouble.error.where);
        }
    }
    return {"Meshes of this session cannot be had.", missing.join(QStringLiteral(", ")).toStdString(),
            "Put them there, or beside the session as they were when that was saved."};
}

Status collect(const QString& session, const QString& folder) {
    Result<SessionDocument> document = readSessionFile(session);
    if (!document) {
        return document.error();
    }
    MeshPlaces places;
    places.folder = QFileInfo(session).absolutePath();
    const Result<PreparedSession> prepared = prepareSession(std::move(document).value(), places);
    if (!prepared) {
        return prepared.error();
    }
    if (!prepared.value().isWhole()) {
        return missingOf(prepared.value());
    }
    MeshesByPath meshes;
    for (const TargetState& target : prepared.value().scene.targets) {
        if (std::holds_alternative<MeshFile>(target.source)) {
            meshes[target.sourcePath] = target.shape.mesh;
        }
    }
    const Result<QStringList> notes =
        collectSession(withPlaces(prepared.value()), meshes, folder, QFileInfo(session).fileName());
    if (!notes) {
        return notes.error();
    }
    for (const QString& note : notes.value()) {
        QTextStream(stderr) << "note: " << note << "\n";
    }
    QTextStream(stdout) << "In " << QDir::toNativeSeparators(folder) << ": " << QFileInfo(session).fileName()
                        << "\n";
    return Done{};
}

}  // namespace

int collectCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Puts a session, its meshes, materials and textures into one folder, which can be moved and\n"
        "handed on. Nothing that exists is replaced."));
    parser.addHelpOption();
    parser.addPositionalArgument(QStringLiteral("session"), QStringLiteral("Session file (.hitscope)."));
    parser.addPositionalArgument(QStringLiteral("folder"), QStringLiteral("Folder; made if missing."));
    if (const std::optional<int> status = parse(parser, QStringLiteral("collect"), arguments)) {
        return *status;
    }
    if (parser.positionalArguments().size() != 2) {
        return wrongUsage(QStringLiteral("collect takes a session file and a folder."));
    }
    return finish(collect(parser.positionalArguments()[0], parser.positionalArguments()[1]));
}

}  // namespace hitscope::cli
