// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/common_options.h"

#include <QTextStream>
#include <cmath>

#include "cli/outputs.h"
#include "cli/pipeline_argument.h"
#include "cli/standard_streams.h"
#include "session/export/export_options.h"

namespace hitscope::cli {

QStringList wordsOf(std::span<const std::string_view> keys) {
    QStringList words;
    for (const std::string_view key : keys) {
        words << QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
    }
    return words;
}

UsageOption quietOption() {
    return flagOption("quiet", QStringLiteral("Print no notes and no progress."));
}

QList<UsageOption> reportOptions() {
    return {
        flagOption("json", QStringLiteral("Print the report as JSON instead of text.")),
        outputOption("report",
                     QStringLiteral("Write the report as JSON to a file, completely or not at all.")),
        flagOption("quiet", QStringLiteral("Print no notes and no progress, and with --report no text."))};
}

UsageOption pipelineOption(const QString& standard) {
    return wordOption("pipeline", "NAME", pipelineWords(),
                      QStringLiteral("Pipeline that applies the hits; default: %1.").arg(standard));
}

std::optional<PipelineKind> givenPipeline(Invocation& given) {
    return given.isSet("pipeline") ? std::optional(allPipelines()[given.word("pipeline")].kind)
                                   : std::nullopt;
}

UsageOption targetOption(const QString& standard) {
    return valueOption("target", "NAME", QStringLiteral("Name of the target; default: %1.").arg(standard));
}

QString givenMeshFile(Invocation& given) {
    QString path = given.text("out");
    if (!path.isEmpty() && !exportFormatOf(path)) {
        QStringList suffixes;
        for (const ExportFormatTraits& format : exportFormats()) {
            suffixes << QLatin1Char('.') + QLatin1String(format.suffix);
        }
        suffixes.removeDuplicates();
        given.complain(QStringLiteral("--out writes a mesh, and \"%1\" has none of the suffixes %2.")
                           .arg(path, suffixes.join(QStringLiteral(", "))));
    }
    return path;
}

Status giveReport(const Invocation& given, JsonReport& report, const QString& text) {
    const std::string json = report.take();
    const bool isData = given.isSet("json") || isStandardStream(given.text("report"));
    const bool isWanted = !isOutputTaken(given) && (!isQuiet() || !given.isSet("report"));
    if (isData || isWanted) {
        QTextStream(stdout) << (isData ? QString::fromStdString(json) : text);
    }
    return given.isSet("report") && !isStandardStream(given.text("report"))
               ? writeAllTo(given.text("report"), json)
               : Status(Done{});
}

std::optional<glm::vec3> vectorOf(const QString& text) {
    const QStringList parts = text.split(u',');
    glm::vec3 made(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        bool isNumber = false;
        made[axis] = parts.value(axis).toFloat(&isNumber);
        if (parts.size() != 3 || !isNumber || !std::isfinite(made[axis])) {
            return std::nullopt;
        }
    }
    return made;
}

}  // namespace hitscope::cli
