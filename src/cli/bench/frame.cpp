// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/history.h"

namespace hitscope::bench {

namespace {

struct FrameOptions {
    CommonOptions common;
    std::vector<int> hits;
    int row = kDefaultPaperRow;
    std::vector<int> vertices;  ///< empty: the paper's row
    bool gentle = false;
};

/// The figures of one scene under one pipeline.
struct FrameSeries {
    QString scene;
    double vertices = 0.0;
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    std::vector<HistoryFigure> figures;
};

/// Frame time over that of the history without hits; 0: there is none.
double overNoHits(const FrameSeries& series, const HistoryFigure& figure) {
    for (const HistoryFigure& base : series.figures) {
        if (base.hits == 0) {
            return timeRatio(figure.frames, base.frames);
        }
    }
    return 0.0;
}

Table tableOf(const FrameSeries& series) {
    Table table;
    table.title = QStringLiteral("%1; %2, %3 vertices")
                      .arg(pipelineName(series.pipeline), series.scene,
                           grouped(static_cast<qulonglong>(series.vertices)));
    table.columns = {QStringLiteral("hits"), QStringLiteral("kept"), QStringLiteral("frame"),
                     QStringLiteral("(range)"), QStringLiteral("over 0 hits")};
    for (const HistoryFigure& figure : series.figures) {
        const double ratio = overNoHits(series, figure);
        table.rows.push_back(
            {grouped(static_cast<qulonglong>(figure.hits)), grouped(figure.kept),
             shortTime(figure.frames.median()),
             QStringLiteral("(%1-%2)").arg(shortTime(figure.frames.least()), shortTime(figure.frames.most())),
             ratio > 0.0 ? QStringLiteral("x%1").arg(ratio, 0, 'f', 3) : QStringLiteral("-")});
    }
    return table;
}

QJsonObject record(const FrameSeries& series, const HistoryFigure& figure, bool gentle) {
    const double ratio = overNoHits(series, figure);
    return {{QStringLiteral("scene"), series.scene},
            {QStringLiteral("vertices"), series.vertices},
            {QStringLiteral("pipeline"), pipelineKey(series.pipeline)},
            {QStringLiteral("gentle"), gentle},
            {QStringLiteral("hits"), figure.hits},
            {QStringLiteral("hits_kept"), static_cast<qint64>(figure.kept)},
            {QStringLiteral("samples"), static_cast<qint64>(figure.frames.size())},
            {QStringLiteral("frame_seconds_median"), figure.frames.median()},
            {QStringLiteral("frame_seconds_least"), figure.frames.least()},
            {QStringLiteral("frame_seconds_most"), figure.frames.most()},
            {QStringLiteral("runs"), runsJson(figure.frames)},
            {QStringLiteral("time_ratio_to_no_hits"), ratio > 0.0 ? QJsonValue(ratio) : QJsonValue()}};
}

QStringList frameNotes(bool gentle) {
    QStringList notes{
        QStringLiteral("Same view in all; nothing arrives while it is measured. Kept: a uniform array "
                       "holds the scene's last hits and drops older ones.")};
    notes << (gentle ? QStringLiteral(
                           "Gentle: the hits move vertices by a micrometre at most, so that all histories "
                           "of a scene give the same picture, and what is compared is their length.")
                     : QStringLiteral(
                           "The hits deform as usual. Thousands of them wreck the shapes, and a wreck costs "
                           "more or less to draw than a sphere: --gentle compares the length alone."));
    return notes;
}

/// All pipelines on one scene; what cannot be measured becomes a note.
Status measureScene(const BenchRoom& room, const FrameOptions& options, const QString& name,
                    const StillScene& scene, Report& report) {
    for (const PipelineKind pipeline : options.common.pipelines) {
        const QString what = QStringLiteral("%1, %2").arg(name, pipelineName(pipeline));
        if (Result<std::unique_ptr<DeformationPipeline>> made = room.makePipeline(pipeline); !made) {
            report.notes << QStringLiteral("%1 cannot run here: %2")
                                .arg(pipelineName(pipeline), QString::fromStdString(made.error().message()));
            continue;
        }
        Result<std::vector<HistoryFigure>> figures = measureHistories(
            room, scene, {pipeline, options.hits, options.gentle, options.common.seed, options.common.plan},
            what);
        if (!figures) {
            report.notes << QString::fromStdString(figures.error().message());
            if (Status status = noGlErrors(); !status) {
                return status;
            }
            continue;
        }
        const FrameSeries series{name, scene.vertices, pipeline, std::move(figures).value()};
        report.tables.push_back(tableOf(series));
        for (const HistoryFigure& figure : series.figures) {
            report.records.push_back(record(series, figure, options.gentle));
        }
    }
    return Done{};
}

/// Those that fit into memory; the others become notes.
Status measureSpheres(const BenchRoom& room, const FrameOptions& options, Report& report) {
    // Asked before a sphere is made, which takes long, and for all that will be in memory with it.
    const double bytesPerVertex =
        kSphereSceneBytes + kHistorySceneBytes * static_cast<double>(options.hits.size());
    std::vector<double> measured;  // vertices
    for (const int vertices : options.vertices) {
        if (const QString why = whyItDoesNotFit(bytesPerVertex * vertices); !why.isEmpty()) {
            report.notes << QStringLiteral("%1 vertices are left out: %2. Ask for fewer numbers of hits.")
                                .arg(grouped(static_cast<qulonglong>(vertices)), why);
            continue;
        }
        room.say(QStringLiteral("making a sphere"));
        const StillScene scene = sphereScene(vertices);
        if (std::find(measured.begin(), measured.end(), scene.vertices) != measured.end()) {
            report.notes << sameAgain(vertices, QStringLiteral("vertices"),
                                      static_cast<std::size_t>(scene.vertices));
            continue;
        }
        measured.push_back(scene.vertices);
        if (Status status = measureScene(room, options, QStringLiteral("sphere"), scene, report); !status) {
            return status;
        }
    }
    return Done{};
}

cli::Outcome measureFrames(const FrameOptions& options, const BenchRoom& room, Report& report) {
    report.fields = {QStringLiteral("scene"),
                     QStringLiteral("vertices"),
                     QStringLiteral("pipeline"),
                     QStringLiteral("gentle"),
                     QStringLiteral("hits"),
                     QStringLiteral("hits_kept"),
                     QStringLiteral("samples"),
                     QStringLiteral("frame_seconds_median"),
                     QStringLiteral("frame_seconds_least"),
                     QStringLiteral("frame_seconds_most"),
                     QStringLiteral("time_ratio_to_no_hits")};
    report.keys = report.fields.first(5);
    report.along = QStringLiteral("hits");
    report.notes = frameNotes(options.gentle);
    const Status status =
        options.vertices.empty()
            ? measureScene(room, options, paperRows()[static_cast<std::size_t>(options.row)].label(),
                           paperRowScene(options.row), report)
            : measureSpheres(room, options, report);
    return status ? whatCameOf(report) : cli::cannotDraw(status.error());
}

int runFrame(Invocation& given) {
    FrameOptions options;
    options.common = takeCommonOptions(given);
    takeSizeInto(options.common, given);
    options.hits = takeCounts(given, "hits", 0, 1000000);
    options.row = takeCount(given, "row", 1, static_cast<int>(paperRows().size())) - 1;
    if (given.isSet("vertices")) {
        options.vertices = takeCounts(given, "vertices", 8, 20000000);
    }
    options.gentle = given.isSet("gentle");
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    return cli::finish(
        runBenchmark(QStringLiteral("frame"), options.common, true,
                     [&](BenchRoom& room, Report& report) { return measureFrames(options, room, report); }));
}

}  // namespace

cli::Verb frameVerb() {
    return {
        {.name = QStringLiteral("bench frame"),
         .files = {},
         .about = QStringLiteral("frame time over the number of hits"),
         .description = QStringLiteral(
             "Measures the frame time of a scene at rest over the number of hits in its history."),
         .options =
             QList<UsageOption>{
                 valueOption("hits", "LIST", QStringLiteral("Numbers of hits; K is a thousand, M a million."),
                             QStringLiteral("0,100,600,1K,10K,100K")),
                 valueOption("row", "N", QStringLiteral("Row of the paper's tables to show, 1 to 9."),
                             QString::number(kDefaultPaperRow + 1)),
                 valueOption("vertices", "LIST",
                             QStringLiteral("Spheres of about this many vertices, instead of a row.")),
                 flagOption(
                     "gentle",
                     QStringLiteral("Use hits too weak to be seen, so that the picture is always the same.")),
                 sizeOption()} +
             commonOptions(),
         .examples = {{QStringLiteral("Measure the cost of 700 hits on a sphere with a few samples."),
                       QStringLiteral("hitscope-cli bench frame --quick --gentle --vertices 8K --hits "
                                      "0,700 --size 320x180")}}},
        runFrame};
}

}  // namespace hitscope::bench
