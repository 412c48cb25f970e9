// SPDX-License-Identifier: GPL-3.0-or-later
// What each way to look at a scene costs, over plain shading.
#include <QTextStream>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/modes_scene.h"
#include "cli/bench/report_header.h"
#include "cli/command_line.h"

namespace hitscope::bench {

namespace {

/// Of the first of a place, which is plain shading.
const Samples& plainOf(std::size_t mode, const std::vector<Samples>& samples) {
    const std::span<const ViewMode> modes = viewModes();
    return samples[static_cast<std::size_t>(&plainModeOf(modes[mode]) - modes.data())];
}

void describe(Report& report, const std::vector<Samples>& samples, PipelineKind pipeline,
              const QString& scene) {
    Table table;
    table.title = QStringLiteral("%1; %2").arg(pipelineName(pipeline), scene);
    table.columns = {QStringLiteral("mode"), QStringLiteral("frame"), QStringLiteral("over plain shading"),
                     QStringLiteral("at most")};
    const std::span<const ViewMode> modes = viewModes();
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const double ratio = timeRatio(samples[i], plainOf(i, samples));
        const QString name = QLatin1String(modes[i].name);
        table.rows.push_back({name, shortTime(samples[i].median()),
                              QStringLiteral("x%1").arg(ratio, 0, 'f', 2), QString::number(modes[i].atMost)});
        report.records.push_back({{QStringLiteral("pipeline"), pipelineKey(pipeline)},
                                  {QStringLiteral("key"), QLatin1String(modes[i].key)},
                                  {QStringLiteral("mode"), name},
                                  {QStringLiteral("frame_seconds_median"), samples[i].median()},
                                  {QStringLiteral("time_ratio_to_plain"), ratio},
                                  {QStringLiteral("at_most"), modes[i].atMost}});
    }
    report.tables.push_back(table);
}

Status runModes(const CommonOptions& options, int row) {
    if (Status status = checkDestinations(options.destinations); !status) {
        return status;
    }
    Result<std::unique_ptr<BenchRoom>> room = BenchRoom::open(options.width, options.height);
    if (!room) {
        return room.error();
    }
    Report report;
    report.benchmark = QStringLiteral("modes");
    report.header = reportHeader(*room.value(), options.width, options.height);
    report.fields = {QStringLiteral("pipeline"),
                     QStringLiteral("key"),
                     QStringLiteral("mode"),
                     QStringLiteral("frame_seconds_median"),
                     QStringLiteral("time_ratio_to_plain"),
                     QStringLiteral("at_most")};
    for (const PipelineKind pipeline : options.pipelines) {
        ModesScene scene(room.value()->picture());
        if (Status status = scene.open(row, pipeline, options.seed); !status) {
            return status;
        }
        std::vector<Variant> variants;
        for (const ViewMode& mode : viewModes()) {
            variants.push_back(scene.variant(mode));
        }
        Result<std::vector<Samples>> samples =
            room.value()->measure(pipelineName(pipeline), variants, options.plan);
        if (!samples) {
            return samples.error();
        }
        describe(report, samples.value(), pipeline,
                 QStringLiteral("%1, %2 vertices")
                     .arg(paperRows()[static_cast<std::size_t>(row)].label(), grouped(scene.vertices())));
    }
    return writeReport(report, options.destinations);
}

}  // namespace

int modesCommand(const QStringList& list) {
    Arguments arguments(
        QStringLiteral("Measures frames of a dented scene in each mode against plain shading."));
    addCommonOptions(arguments, true);
    arguments.addOption(QStringLiteral("row"), QStringLiteral("Row of the paper's tables to show."),
                        QStringLiteral("number"), QString::number(kFullestRow + 1));
    parseBenchArguments(arguments, list);
    if (arguments.error().isEmpty() && arguments.wantsHelp()) {
        QTextStream(stdout) << arguments.help(QStringLiteral("modes"));
        return 0;
    }
    const CommonOptions options = takeCommonOptions(arguments, true);
    const int row = arguments.wholeNumber(QStringLiteral("row"), 1, static_cast<int>(paperRows().size())) - 1;
    if (!arguments.error().isEmpty()) {
        return cli::wrongUsage(arguments.error());
    }
    return cli::finish(runModes(options, row));
}

}  // namespace hitscope::bench
