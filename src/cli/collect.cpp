// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a session, its meshes and textures into one folder.
#include <QDir>
#include <QFileInfo>
#include <QTextStream>
#include <algorithm>

#include "cli/command_line.h"
#include "cli/common_options.h"
#include "cli/opened_scene.h"
#include "cli/standard_streams.h"
#include "cli/verbs.h"
#include "document/collect_session.h"

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

Status collect(const QString& session, const QString& folder) {
    const Result<PreparedSession> prepared = prepareFrom(session);
    if (!prepared) {
        return prepared.error();
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
    for (const QString& said : notes.value()) {
        note(QStringLiteral("note: ") + said);
    }
    QTextStream(stdout) << "In " << QDir::toNativeSeparators(folder) << ": " << QFileInfo(session).fileName()
                        << "\n";
    return Done{};
}

int runCollect(Invocation& given) {
    if (isStandardStream(given.file(0))) {
        given.complain(QStringLiteral("collect takes a session file, not the standard input."));
        return kWrongUsage;
    }
    return finish(collect(given.file(0), given.file(1)));
}

}  // namespace

Verb collectVerb() {
    return {{.name = QStringLiteral("collect"),
             .files = QStringLiteral("SESSION FOLDER"),
             .about = QStringLiteral("copy a session, its meshes and textures into one folder"),
             .description = QStringLiteral(
                 "Copies a session with its meshes, materials and textures into one folder, which you can "
                 "move and share. Creates the folder if needed and never replaces an existing file."),
             .options = {quietOption()},
             .examples = {{QStringLiteral("Collect a session to share it."),
                           QStringLiteral("hitscope-cli collect dents.hitscope to-share")}},
             .leastFiles = 2,
             .mostFiles = 2},
            runCollect};
}

}  // namespace hitscope::cli
