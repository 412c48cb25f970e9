// SPDX-License-Identifier: GPL-3.0-or-later
// Writes targets of a session, or a mesh, in any format that the window writes.
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "cli/agreement.h"
#include "cli/common_options.h"
#include "cli/opened_scene.h"
#include "cli/standard_streams.h"
#include "cli/target_argument.h"
#include "cli/verbs.h"
#include "session/export/export_target.h"

namespace hitscope::cli {

namespace {

QStringList formatWords() {
    QStringList words;
    for (const ExportFormatTraits& traits : exportFormats()) {
        words << QString::fromUtf8(traits.key);
    }
    return words;
}

/// What export and convert have in common.
QList<UsageOption> writingOptions() {
    return {
        wordOption("format", "NAME", formatWords(), QStringLiteral("Format; default: by the file's suffix.")),
        wordOption("normals", "KIND", {QStringLiteral("true"), QStringLiteral("paper")},
                   QStringLiteral("Normals of the deformed surface."), QStringLiteral("true")),
        flagOption("all-normals",
                   QStringLiteral("OBJ: write a normal for each corner, even if the mesh's file has none.")),
        flagOption("check", QStringLiteral("Read the file back and compare it with the mesh."))};
}

/// What --format says, or else the suffix; a complaint where neither does.
ExportOptions readWriting(Invocation& given, const QString& path) {
    ExportOptions options;
    const std::optional<ExportFormat> bySuffix = exportFormatOf(path);
    if (given.isSet("format")) {
        options.format = exportFormats()[given.word("format")].format;
    } else if (bySuffix) {
        options.format = *bySuffix;
    } else {
        given.complain(QStringLiteral("the format of \"%1\" is not known; --format takes one of %2.")
                           .arg(path, formatWords().join(QStringLiteral(", "))));
    }
    if (isStandardStream(path) && options.format == ExportFormat::Gltf) {
        given.complain(
            QStringLiteral("glTF is written into two files; take --format glb for the standard output."));
    }
    if (given.isSet("all-normals") && options.format != ExportFormat::Obj) {
        given.complain(QStringLiteral("--all-normals goes with OBJ."));
    }
    if (given.isSet("check") && options.format == ExportFormat::Csv) {
        given.complain(QStringLiteral("--check goes with meshes; CSV is a table."));
    }
    options.normals = given.word("normals") == 0 ? NormalMode::True : NormalMode::Paper;
    options.allNormals = given.isSet("all-normals");
    options.readBack = given.isSet("check");
    options.isAlone = isStandardStream(path);
    return options;
}

Status copyToOutput(const QString& path) {
    const Result<QByteArray> bytes = readAllOf(path, qint64{1} << 40);
    return bytes ? writeAllTo(QStringLiteral("-"),
                              {bytes.value().constData(), static_cast<std::size_t>(bytes.value().size())})
                 : Status(bytes.error());
}

Outcome write(Invocation& given, const Session& session, const std::vector<const Target*>& targets,
              const ExportOptions& options, const QString& path) {
    const ScratchFolder scratch;
    const bool isStream = isStandardStream(path);
    if (Status made = scratch.check(); isStream && !made) {
        return made;
    }
    const QString place =
        isStream ? scratch.file(QStringLiteral("mesh.") + QString::fromUtf8(traitsOf(options.format).suffix))
                 : path;
    const Result<ExportReport> written = writeExport(copyForExport(session, targets, options), place);
    if (!written) {
        return written.error();
    }
    for (const QString& said : written.value().notes) {
        note(said);
    }
    if (isStream) {
        if (const QStringList left = scratch.filesBeside(place); !left.isEmpty()) {
            note(
                QStringLiteral("note: the mesh refers to files that the standard output has no room for: %1.")
                    .arg(left.join(QStringLiteral(", "))));
        }
        return copyToOutput(place);
    }
    JsonReport report(given.usage().name.toStdString());
    QStringList names;
    report.text("file", path).text("format", QString::fromUtf8(traitsOf(options.format).key));
    report.count("bytes", static_cast<std::uint64_t>(QFileInfo(path).size()));
    report.truth("was_read_back", written.value().wasReadBack).beginArray("targets");
    for (const Target* target : targets) {
        names << target->name;
        report.text({}, target->name);
    }
    report.endArray().beginArray("notes");
    for (const QString& said : written.value().notes) {
        report.text({}, said);
    }
    report.endArray();
    return giveReport(
        given, report,
        QStringLiteral("In %1: %2%3\n")
            .arg(QDir::toNativeSeparators(path), names.join(QStringLiteral(", ")),
                 written.value().wasReadBack ? QStringLiteral("; read back, it is the same") : QString()));
}

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
    return write(given, session, targets, options, given.text("out"));
}

int runExport(Invocation& given) {
    SceneWish wish{given.file(0), givenPipeline(given)};
    if (given.isSet("until")) {
        wish.until = static_cast<std::size_t>(given.wholeNumber("until", 0, 2147483647));
    }
    if (given.text("out").isEmpty()) {
        given.complain(QStringLiteral("export needs --out, a file to write."));
        return kWrongUsage;
    }
    if (given.isSet("all") && given.isSet("target")) {
        given.complain(QStringLiteral("--all and --target exclude each other."));
    }
    ExportOptions options = readWriting(given, given.text("out"));
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

Outcome convert(Invocation& given, const ExportOptions& options) {
    OpenedScene scene;
    if (Outcome opened = scene.open({.path = given.file(0), .isMeshAlone = true}); !opened) {
        return opened;
    }
    return write(given, scene.session(), {scene.session().targets().front().get()}, options, given.file(1));
}

int runConvert(Invocation& given) {
    if (namesSession(given.file(0))) {
        given.complain(QStringLiteral("convert takes a mesh; export writes what is in a session."));
    }
    const ExportOptions options = readWriting(given, given.file(1));
    return given.error().isEmpty() ? finish(convert(given, options)) : kWrongUsage;
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
                 valueOption("until", "N", QStringLiteral("Apply only the first N hits.")),
                 pipelineOption(QStringLiteral("the session's"))} +
             writingOptions() + reportOptions(),
         .examples = {{QStringLiteral("Write the deformed mesh as PLY, read it back and compare it."),
                       QStringLiteral("hitscope-cli export --check --out dented.ply dents.hitscope")},
                      {QStringLiteral("Pass an OBJ to another program."),
                       QStringLiteral("hitscope-cli export --format obj --out - dents.hitscope | wc -l")}},
         .leastFiles = 1,
         .mostFiles = 1},
        runExport};
}

Verb convertVerb() {
    return {
        {.name = QStringLiteral("convert"),
         .files = QStringLiteral("MESH FILE"),
         .about = QStringLiteral("write a mesh in another format"),
         .description = QStringLiteral("Reads a mesh and writes it in another format. FILE may be - for the "
                                       "standard output. Keeps the order of vertices if the format has one."),
         .options = writingOptions() + reportOptions(),
         .examples = {{QStringLiteral("Convert OBJ to GLB."),
                       QStringLiteral("hitscope-cli convert bunny.obj bunny.glb")}},
         .leastFiles = 2,
         .mostFiles = 2,
         .outputFile = 1},
        runConvert};
}

}  // namespace hitscope::cli
