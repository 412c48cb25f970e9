// SPDX-License-Identifier: GPL-3.0-or-later
// What a person waits for in the window: clicks, undo, opening, exports, frames, the aim preview, scattered
// hits.
#include <QTextStream>

#include "cli/bench/arguments.h"
#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/window/window_cost.h"
#include "cli/bench/window/window_run.h"
#include "cli/command_line.h"

namespace hitscope::bench {

namespace {

struct LatencyRequest {
    CommonOptions common;
    std::vector<int> vertices;
    int scattered = 0;
};

QString timesOf(const Samples& samples) {
    return QStringLiteral("%1 to %2").arg(shortTime(samples.least()), shortTime(samples.most()));
}

void addMesh(Report& report, const LatencyFigures& figures) {
    const QString vertices = grouped(figures.vertices);
    Table table;
    table.title = QStringLiteral("A mesh of %1 vertices; a click moves %2; picture of %3x%4 pixels")
                      .arg(vertices, grouped(figures.moved))
                      .arg(figures.viewport.width())
                      .arg(figures.viewport.height());
    table.columns = {QString(),
                     QStringLiteral("median"),
                     QStringLiteral("least to most"),
                     QStringLiteral("events wait"),
                     QStringLiteral("at most"),
                     QStringLiteral("processor"),
                     QStringLiteral("samples")};
    for (const LatencyRow& row : figures.rows) {
        table.rows.push_back({row.measured, shortTime(row.seconds.median()), timesOf(row.seconds),
                              shortTime(row.blocked.median()), shortTime(row.blocked.most()),
                              shortTime(row.processor.median()), QString::number(row.seconds.size())});
        report.records.push_back({{QStringLiteral("vertices"), static_cast<qint64>(figures.vertices)},
                                  {QStringLiteral("moved"), static_cast<qint64>(figures.moved)},
                                  {QStringLiteral("measured"), row.measured},
                                  {QStringLiteral("samples"), static_cast<qint64>(row.seconds.size())},
                                  {QStringLiteral("seconds_median"), row.seconds.median()},
                                  {QStringLiteral("seconds_least"), row.seconds.least()},
                                  {QStringLiteral("seconds_most"), row.seconds.most()},
                                  {QStringLiteral("blocked_median"), row.blocked.median()},
                                  {QStringLiteral("blocked_most"), row.blocked.most()},
                                  {QStringLiteral("processor_median"), row.processor.median()},
                                  {QStringLiteral("runs"), runsJson(row.seconds)}});
    }
    report.tables.push_back(std::move(table));
}

Report emptyLatencyReport() {
    Report report;
    report.benchmark = QStringLiteral("latency");
    report.fields = {QStringLiteral("vertices"),       QStringLiteral("moved"),
                     QStringLiteral("measured"),       QStringLiteral("samples"),
                     QStringLiteral("seconds_median"), QStringLiteral("seconds_least"),
                     QStringLiteral("seconds_most"),   QStringLiteral("blocked_median"),
                     QStringLiteral("blocked_most"),   QStringLiteral("processor_median")};
    report.keys = {QStringLiteral("vertices"), QStringLiteral("measured")};
    report.notes << QStringLiteral(
        "Times run from the key, click or drop until the window has swapped in a frame that shows the "
        "result. \"events wait\" is how long an event was kept waiting at most until then, median and worst; "
        "\"processor\" is the time of all threads of the window: where other programs run too, it says more "
        "than the clock. "
        "Pictures at rest are refined in the two rows of the teapot, which run from the frame with which "
        "the picture came to rest to the one that shows sixteen samples; in the row of the aim preview over "
        "a refined picture; and during the exports. A picture that takes the renderer long is shown with "
        "fewer triangles first: \"in full\" says when all of them were there. The aim preview's 150 ms of "
        "rest do not count.");
    return report;
}

cli::Outcome runLatency(const LatencyRequest& request) {
    if (Status status = checkDestinations(request.common.destinations); !status) {
        return status;
    }
    const Result<std::unique_ptr<WindowRoom>> room =
        WindowRoom::open(request.common.width, request.common.height);
    if (!room) {
        return cli::cannotDraw(room.error());
    }
    Report report = emptyLatencyReport();
    for (const int vertices : differentSheets(request.vertices, report.notes)) {
        const Result<LatencyFigures> figures =
            measureWindowLatency(*room.value(), {vertices, request.scattered, request.common.plan});
        if (!figures) {
            return cli::cannotDraw(figures.error());
        }
        report.header = windowReportHeader(*room.value(), figures.value().renderer, request.common.width,
                                           request.common.height);
        addMesh(report, figures.value());
    }
    return writeReport(report, request.common.destinations);
}

int runLatencyVerb(Invocation& given) {
    LatencyRequest request;
    request.common = takeMeasuringOptions(given);
    takeSizeInto(request.common, given);
    request.vertices = takeCounts(given, "vertices", kLeastSheet, kMostSheet);
    request.scattered = takeCount(given, "scattered", 0, kMostScattered);
    return given.error().isEmpty() ? cli::finish(runLatency(request)) : cli::kWrongUsage;
}

}  // namespace

cli::Verb latencyVerb() {
    return {{.name = QStringLiteral("bench latency"),
             .files = {},
             .about = QStringLiteral("response times of the window: clicks, undo, opening, exports, frames"),
             .description =
                 QStringLiteral("Measures the response times of the window to events like those of mouse and "
                                "keyboard, on the current display or, without one, on a virtual display "
                                "(Xvfb). Creates the mesh files in the folder for temporary files."),
             .options =
                 QList<UsageOption>{
                     valueOption(
                         "vertices", "LIST",
                         QStringLiteral("Numbers of vertices of the meshes, measured one after the other."),
                         QStringLiteral("8K,100K,1M")),
                     valueOption("size", "WIDTHxHEIGHT", QStringLiteral("Size of the window in pixels."),
                                 QStringLiteral("1600x1000")),
                     valueOption("scattered", "N",
                                 QStringLiteral("Number of hits scattered over the mesh at once; 0: none."),
                                 QStringLiteral("10K"))} +
                 measuringOptions(),
             .examples =
                 {{QStringLiteral("Measure a small mesh with a few samples."),
                   QStringLiteral(
                       "hitscope-cli bench latency --quick --vertices 1K --size 640x480 --scattered 0")}}},
            runLatencyVerb};
}

}  // namespace hitscope::bench
