// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_writing.h"

#include <QDir>
#include <QFileInfo>

#include "cli/common_options.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
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

}  // namespace

QList<UsageOption> writingOptions() {
    return {
        wordOption("format", "NAME", formatWords(), QStringLiteral("Format; default: by the file's suffix.")),
        wordOption("normals", "KIND", {QStringLiteral("true"), QStringLiteral("paper")},
                   QStringLiteral("Normals of the deformed surface."), QStringLiteral("true")),
        flagOption("all-normals",
                   QStringLiteral("OBJ: write a normal for each corner, even if the mesh's file has none.")),
        flagOption("check", QStringLiteral("Read the file back and compare it with the mesh."))};
}

ExportOptions givenWriting(Invocation& given, const QString& path) {
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
    const QString suffix = QString::fromUtf8(traitsOf(options.format).suffix);
    const bool isOther = !isStandardStream(path) && QFileInfo(path).suffix().toLower() != suffix;
    if (given.isSet("check") && options.format != ExportFormat::Csv && isOther) {
        given.complain(QStringLiteral("--check reads the file back by its suffix; name \"%1\" with .%2.")
                           .arg(path, suffix));
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

namespace {

/// What was written, as its report has it.
struct WrittenMesh {
    QString path;             ///< as it was given; - for the standard output, which no text goes to then
    std::uint64_t bytes = 0;  ///< without the files beside it
    const char* format = "";  ///< as --format takes it
};

Status reportWriting(const Invocation& given, const WrittenMesh& mesh,
                     const std::vector<const Target*>& targets, const ExportReport& written) {
    JsonReport report(given.usage().name.toStdString());
    QStringList names;
    report.text("file", mesh.path).text("format", QString::fromUtf8(mesh.format));
    report.count("bytes", mesh.bytes).truth("was_read_back", written.wasReadBack).beginArray("targets");
    for (const Target* target : targets) {
        names << target->name;
        report.text({}, target->name);
    }
    report.endArray().beginArray("notes");
    for (const QString& said : written.notes) {
        report.text({}, said);
    }
    report.endArray();
    return giveReport(
        given, report,
        QStringLiteral("In %1: %2%3\n")
            .arg(QDir::toNativeSeparators(mesh.path), names.join(QStringLiteral(", ")),
                 written.wasReadBack ? QStringLiteral("; read back, it is the same") : QString()));
}

Status copyToOutput(const QString& path) {
    const Result<QByteArray> bytes = readAllOf(path, qint64{1} << 40);
    return bytes ? writeAllTo(QStringLiteral("-"),
                              {bytes.value().constData(), static_cast<std::size_t>(bytes.value().size())})
                 : Status(bytes.error());
}

}  // namespace

Outcome writeTargets(Invocation& given, const Session& session, const std::vector<const Target*>& targets,
                     const ExportOptions& options, const QString& path) {
    const ScratchFolder scratch;
    const bool isStream = isStandardStream(path);
    if (Status made = scratch.check(); isStream && !made) {
        return made;
    }
    const QString place =
        isStream ? scratch.file(QStringLiteral("mesh.") + QString::fromUtf8(traitsOf(options.format).suffix))
                 : path;
    const Result<ExportReport> written = [&] {
        const WaitingLine waiting(QStringLiteral("Writing"));
        return writeExport(copyForExport(session, targets, options), place);
    }();
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
        if (Status copied = copyToOutput(place); !copied) {
            return copied;
        }
    }
    const WrittenMesh mesh{path, static_cast<std::uint64_t>(QFileInfo(place).size()),
                           traitsOf(options.format).key};
    return reportWriting(given, mesh, targets, written.value());
}

}  // namespace hitscope::cli
