// SPDX-License-Identifier: GPL-3.0-or-later
// Writes targets of a session in any format that the window writes.
#include "cli/agreement.h"
#include "cli/common_options.h"
#include "cli/mesh_writing.h"
#include "cli/opened_scene.h"
#include "cli/scene_options.h"
#include "cli/target_argument.h"
#include "cli/verbs.h"

namespace hitscope::cli {

namespace {

Outcome exportScene(Invocation& given, const SceneWish& wish, const ExportOptions& options) {
    OpenedScene scene;
    if (Outcome opened = scene.open(wish); !opened) {
        return opened;
    }
    scene.noteDiffering();
    const Session& session = scene.session();
    if (session.targets().empty()) {
        return Error{"The session has no target to write.", wish.path.toStdString(), ""};
    }
    std::vector<const Target*> targets{&mostChangedTarget(session)};
    if (given.isSet("all") || given.isSet("target")) {
        const Result<std::vector<const Target*>> named = targetsNamed(session, given.text("target"));
        if (!named) {
            return named.error();
        }
        targets = named.value();
    }
    return writeTargets(given, session, targets, options, given.text("out"));
}

int runExport(Invocation& given) {
    const SceneWish wish = givenScene(given, given.file(0));
    if (given.text("out").isEmpty()) {
        given.complain(QStringLiteral("export needs --out, a file to write."));
        return kWrongUsage;
    }
    if (given.isSet("all") && given.isSet("target")) {
        given.complain(QStringLiteral("--all and --target exclude each other."));
    }
    ExportOptions options = givenWriting(given, given.text("out"));
    options.inWorld = given.isSet("world");
    options.steps = static_cast<std::size_t>(given.wholeNumber("steps", 0, 100000));
    options.stepOf = static_cast<MorphUnit>(given.word("step-of"));
    if (options.steps > 0 && options.format != ExportFormat::Glb && options.format != ExportFormat::Gltf) {
        given.complain(QStringLiteral("--steps goes with GLB and glTF."));
    }
    if (given.isSet("step-of") && options.steps == 0) {
        given.complain(QStringLiteral("--step-of needs --steps."));
    }
    return given.error().isEmpty() ? finish(exportScene(given, wish, options)) : kWrongUsage;
}

}  // namespace

Verb exportVerb() {
    return {
        {.name = QStringLiteral("export"),
         .files = QStringLiteral("SESSION|MESH"),
         .about = QStringLiteral("write the deformed targets of a session"),
         .description = QStringLiteral("Writes the deformed mesh in the vertex order of its file, as OBJ, "
                                       "PLY, STL, GLB or glTF, or the table of changed vertices as CSV."),
         .options =
             QList<UsageOption>{
                 outputOption("out", QStringLiteral("File to write; - for the standard output.")),
                 targetOption(QStringLiteral("the one with the most changed vertices")),
                 flagOption("all", QStringLiteral("Write all targets, as one mesh.")),
                 flagOption(
                     "world",
                     QStringLiteral("Use the coordinates of the scene instead of those of the mesh's file.")),
                 valueOption("steps", "N",
                             QStringLiteral("glTF: most intermediate shapes, evenly spaced over the hits, as "
                                            "an animation."),
                             QStringLiteral("0")),
                 wordOption("step-of", "UNIT", {QStringLiteral("hit"), QStringLiteral("group")},
                            QStringLiteral("glTF: make an intermediate shape for each hit, or for each run "
                                           "of hits of one group."),
                            QStringLiteral("hit")),
                 untilOption(), pipelineOption(QStringLiteral("the session's"))} +
             writingOptions() + reportOptions(),
         .examples = {{QStringLiteral("Write the deformed mesh as PLY, read it back and compare it."),
                       QStringLiteral("hitscope-cli export --check --out dented.ply dents.hitscope")},
                      {QStringLiteral("Pass an OBJ to another program."),
                       QStringLiteral("hitscope-cli export --format obj --out - dents.hitscope | wc -l")}},
         .leastFiles = 1,
         .mostFiles = 1},
        runExport};
}

}  // namespace hitscope::cli
