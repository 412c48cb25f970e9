// SPDX-License-Identifier: GPL-3.0-or-later
// What the window has in memory with a large mesh: opened, after hits, after undo, after closing.
#include <QTextStream>
#include <cmath>

#include "cli/bench/arguments.h"
#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/window/window_cost.h"
#include "cli/bench/window/window_run.h"
#include "cli/command_line.h"

namespace hitscope::bench {

namespace {

struct MemoryRequest {
    CommonOptions common;
    std::vector<int> vertices;
    int hits = 0;
};

QString bytesText(double bytes) {
    constexpr double kKilobyte = 1024.0;
    constexpr double kMegabyte = 1024.0 * 1024.0;
    return std::abs(bytes) < kMegabyte ? QStringLiteral("%1 KiB").arg(shortNumber(bytes / kKilobyte))
                                       : QStringLiteral("%1 MiB").arg(shortNumber(bytes / kMegabyte));
}

void addMemory(Report& report, const MemoryFigures& figures) {
    Table table;
    table.title = QStringLiteral("A mesh of %1 vertices, %2 hits of about 80 vertices")
                      .arg(grouped(figures.vertices), grouped(figures.hits));
    table.columns = {QString(), QStringLiteral("PSS"), QStringLiteral("RSS"),
                     QStringLiteral("PSS over the mesh's positions and triangles")};
    for (const MemoryRow& row : figures.rows) {
        table.rows.push_back({row.about, bytesText(row.share), bytesText(row.resident),
                              row.ofMesh ? shortNumber(row.share / figures.meshBytes) : QString()});
        QJsonObject& record = report.records.emplace_back(
            QJsonObject{{QStringLiteral("vertices"), static_cast<qint64>(figures.vertices)},
                        {QStringLiteral("hits"), static_cast<qint64>(figures.hits)},
                        {QStringLiteral("measured"), row.measured},
                        {QStringLiteral("share"), row.share},
                        {QStringLiteral("resident"), row.resident}});
        if (row.share > 0.0) {  // a few hits may seem to take nothing, or less
            record.insert(QStringLiteral("runs"), QJsonArray{row.share});
            record.insert(QStringLiteral("unit"), QStringLiteral("B"));
        }
    }
    report.tables.push_back(std::move(table));
}

cli::Outcome runMemory(const MemoryRequest& request) {
    if (Status status = checkDestinations(request.common.destinations); !status) {
        return status;
    }
    const Result<std::unique_ptr<WindowRoom>> room =
        WindowRoom::open(request.common.width, request.common.height);
    if (!room) {
        return cli::cannotDraw(room.error());
    }
    Report report;
    report.benchmark = QStringLiteral("memory");
    report.fields = {QStringLiteral("vertices"), QStringLiteral("hits"), QStringLiteral("measured"),
                     QStringLiteral("share"), QStringLiteral("resident")};
    report.keys = {QStringLiteral("vertices"), QStringLiteral("measured")};
    report.notes << QStringLiteral(
        "PSS is the window's share of what is in memory, RSS all that it maps. A software renderer's "
        "buffers and textures are part of both; a GPU's are not.");
    for (const int vertices : differentSheets(request.vertices, report.notes)) {
        const Result<MemoryFigures> figures = measureWindowMemory(*room.value(), {vertices, request.hits});
        if (!figures) {
            return cli::cannotDraw(figures.error());
        }
        report.header = windowReportHeader(*room.value(), figures.value().renderer, request.common.width,
                                           request.common.height);
        addMemory(report, figures.value());
    }
    return writeReport(report, request.common.destinations);
}

int runMemoryVerb(Invocation& given) {
    MemoryRequest request;
    request.common.destinations = takeDestinations(given);
    takeSizeInto(request.common, given);
    request.vertices = takeCounts(given, "vertices", kLeastSheet, kMostSheet);
    request.hits = takeCount(given, "hits", 1, kMostScattered);
    return given.error().isEmpty() ? cli::finish(runMemory(request)) : cli::kWrongUsage;
}

}  // namespace

cli::Verb memoryVerb() {
    return {
        {.name = QStringLiteral("bench memory"),
         .files = {},
         .about = QStringLiteral("memory of the window with a large mesh, and of each hit"),
         .description = QStringLiteral(
             "Measures the memory of the window with a large mesh, on the current display or, without one, "
             "on a virtual display (Xvfb). Creates the mesh files in the folder for temporary files."),
         .options =
             QList<UsageOption>{
                 valueOption(
                     "vertices", "LIST",
                     QStringLiteral("Numbers of vertices of the meshes, measured one after the other."),
                     QStringLiteral("2M")),
                 valueOption("size", "WIDTHxHEIGHT", QStringLiteral("Size of the window in pixels."),
                             QStringLiteral("1600x1000")),
                 valueOption("hits", "N", QStringLiteral("Number of hits, of about 80 vertices each."),
                             QStringLiteral("500"))} +
             destinationOptions(),
         .examples = {{QStringLiteral("Measure a mesh of ten thousand vertices."),
                       QStringLiteral("hitscope-cli bench memory --vertices 10K --size 640x480 --hits 10")}}},
        runMemoryVerb};
}

}  // namespace hitscope::bench
