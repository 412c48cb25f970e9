// SPDX-License-Identifier: GPL-3.0-or-later
// What each way to look at a scene costs, over plain shading.
#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/modes_scene.h"

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
                                  {QStringLiteral("runs"), runsJson(samples[i])},
                                  {QStringLiteral("frame_seconds_median"), samples[i].median()},
                                  {QStringLiteral("time_ratio_to_plain"), ratio},
                                  {QStringLiteral("at_most"), modes[i].atMost}});
    }
    report.tables.push_back(table);
}

cli::Outcome measureModes(const CommonOptions& options, int row, const BenchRoom& room, Report& report) {
    report.fields = {QStringLiteral("pipeline"),
                     QStringLiteral("key"),
                     QStringLiteral("mode"),
                     QStringLiteral("frame_seconds_median"),
                     QStringLiteral("time_ratio_to_plain"),
                     QStringLiteral("at_most")};
    report.keys = report.fields.first(2);
    for (const PipelineKind pipeline : options.pipelines) {
        if (Result<std::unique_ptr<DeformationPipeline>> made = room.makePipeline(pipeline); !made) {
            report.notes << QStringLiteral("%1 cannot run here: %2")
                                .arg(pipelineName(pipeline), QString::fromStdString(made.error().message()));
            continue;
        }
        ModesScene scene(room.picture());
        if (Status status = scene.open(row, pipeline, options.seed); !status) {
            return cli::cannotDraw(status.error());
        }
        std::vector<Variant> variants;
        for (const ViewMode& mode : viewModes()) {
            variants.push_back(scene.variant(mode));
        }
        Result<std::vector<Samples>> samples = room.measure(pipelineName(pipeline), variants, options.plan);
        if (!samples) {
            return cli::cannotDraw(samples.error());
        }
        describe(report, samples.value(), pipeline,
                 QStringLiteral("%1, %2 vertices")
                     .arg(paperRows()[static_cast<std::size_t>(row)].label(), grouped(scene.vertices())));
    }
    return whatCameOf(report);
}

int runModes(Invocation& given) {
    CommonOptions options = takeCommonOptions(given);
    takeSizeInto(options, given);
    const int row = takeCount(given, "row", 1, static_cast<int>(paperRows().size())) - 1;
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    return cli::finish(runBenchmark(
        QStringLiteral("modes"), options, true,
        [&](BenchRoom& room, Report& report) { return measureModes(options, row, room, report); }));
}

}  // namespace

cli::Verb modesVerb() {
    return {
        {.name = QStringLiteral("bench modes"),
         .files = {},
         .about = QStringLiteral("frame time of each display mode, compared with plain shading"),
         .description = QStringLiteral(
             "Measures the frame time of a dented scene in each display mode, compared with plain shading."),
         .options =
             QList<UsageOption>{
                 valueOption("row", "N", QStringLiteral("Row of the paper's tables to show, 1 to 9."),
                             QString::number(kFullestRow + 1)),
                 sizeOption()} +
             commonOptions(),
         .examples = {{QStringLiteral("Measure one pipeline on a small scene with a few samples."),
                       QStringLiteral("hitscope-cli bench modes --quick --row 6 --pipelines "
                                      "transform-feedback --size 160x90")}}},
        runModes};
}

}  // namespace hitscope::bench
