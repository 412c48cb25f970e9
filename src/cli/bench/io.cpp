// SPDX-License-Identifier: GPL-3.0-or-later
// How fast files come in and go out, beside what other programs need for the same file.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/io_cost.h"
#include "cli/standard_streams.h"
#include "io/import.h"

namespace hitscope::bench {

namespace {

constexpr int kMostFaces = 50'000'000;
// Of what an import writes to, at most; measured with files that just do not fit what arrays have grown to.
constexpr double kImportedPerQuad = 270.0;
constexpr double kImportedPerPlyTriangle = 54.0;
// Of all that is in memory at once; measured with 300,000 quads and 3,000,000 triangles, and a little more.
constexpr double kBytesPerQuad = 1500.0;
constexpr double kBytesPerPlyTriangle = 200.0;
constexpr double kMostPeak = 1.2e9;  // bytes
constexpr double kMostPlySeconds = 10.0;

struct IoOptions {
    CommonOptions common;
    IoSizes sizes;
    bool strict = false;
};

struct IoRow {
    const char* what;
    const char* field;
    const Samples& samples;
    const Samples* over = nullptr;   ///< what it is compared with
    const char* overWhat = "";       ///< its name
    std::optional<double> atMost{};  ///< of the quotient
};

std::vector<IoRow> rowsOf(const IoFigures& figures) {
    return {{"tinyobjloader parses the OBJ file", "tinyobjloader", figures.tiny},
            {"Assimp reads it", "assimp", figures.assimp, &figures.tiny, "tinyobjloader"},
            {"Hitscope, to the first picture, a coarse one", "first picture", figures.coarse, &figures.tiny,
             "tinyobjloader", 2.0},
            {"Hitscope, to the full picture", "picture", figures.picture, &figures.tiny, "tinyobjloader"},
            {"cp of it, with its sync", "cp", figures.copy},
            {"export after three hits", "export few", figures.exportFew, &figures.copy, "cp", 1.5},
            {"export after hits everywhere", "export all", figures.exportAll, &figures.copyAgain, "cp", 3.0}};
}

/// Whether all that has a limit keeps it.
struct Judged {
    Table table;
    std::vector<QJsonObject> records;
    bool allKept = true;

    void add(const QString& what, const QString& field, const QString& measured, double value,
             const QString& compared, std::optional<double> ratio, std::optional<double> atMost,
             const QString& bound, const QJsonArray& runs, const QString& unit = {}) {
        const bool kept = !atMost || ratio.value_or(value) <= *atMost;
        allKept = allKept && kept;
        table.rows.push_back({what, measured, compared, bound,
                              !atMost ? QString()
                              : kept  ? QStringLiteral("yes")
                                      : QStringLiteral("no")});
        records.push_back({{QStringLiteral("measured"), field},
                           {QStringLiteral("value"), value},
                           {QStringLiteral("ratio"), ratio ? QJsonValue(*ratio) : QJsonValue()},
                           {QStringLiteral("at_most"), atMost ? QJsonValue(*atMost) : QJsonValue()},
                           {QStringLiteral("kept"), atMost ? QJsonValue(kept) : QJsonValue()},
                           {QStringLiteral("runs"), runs}});
        if (!unit.isEmpty()) {
            records.back().insert(QStringLiteral("unit"), unit);
        }
    }
};

Judged judge(const IoFigures& figures, const IoOptions& options) {
    Judged judged;
    judged.table.title =
        QStringLiteral("An OBJ file of %1 quads with texture coordinates and normals (%2 MB)")
            .arg(grouped(static_cast<qulonglong>(options.sizes.quads)))
            .arg(static_cast<double>(figures.objBytes) * 1.0e-6, 0, 'f', 1);
    judged.table.columns = {QString(), QStringLiteral("median"), QStringLiteral("compared"),
                            QStringLiteral("at most"), QStringLiteral("kept")};
    for (const IoRow& row : rowsOf(figures)) {
        const std::optional<double> ratio =
            row.over == nullptr ? std::nullopt : std::optional(timeRatio(row.samples, *row.over));
        const QString compared =
            ratio ? QStringLiteral("%1 x %2").arg(*ratio, 0, 'f', 2).arg(QLatin1String(row.overWhat))
                  : QString();
        judged.add(QLatin1String(row.what), QLatin1String(row.field), shortTime(row.samples.median()),
                   row.samples.median(), compared, ratio, row.atMost,
                   row.atMost ? QString::number(*row.atMost) : QString(), runsJson(row.samples));
    }
    const auto gigabytes = [](double bytes) {
        return QStringLiteral("%1 GB").arg(1.0e-9 * bytes, 0, 'f', 2);
    };
    judged.add(QStringLiteral("memory of a program that draws it and its worker"), QStringLiteral("memory"),
               gigabytes(figures.peakBytes), figures.peakBytes, {}, std::nullopt, kMostPeak,
               gigabytes(kMostPeak), {figures.peakBytes}, QStringLiteral("B"));
    if (!figures.ply.empty()) {
        judged.add(QStringLiteral("a binary PLY of %1 triangles, to the full picture")
                       .arg(grouped(static_cast<qulonglong>(options.sizes.plyTriangles))),
                   QStringLiteral("ply"), shortTime(figures.ply.median()), figures.ply.median(), {},
                   std::nullopt, kMostPlySeconds, shortTime(kMostPlySeconds), runsJson(figures.ply));
    }
    judged.table.notes << QStringLiteral(
        "Quotients are of times taken in turn. Memory is the share of both processes (PSS), looked at 50 "
        "times a "
        "second. Limits hold for 2,000,000 quads and 10,000,000 triangles.");
    return judged;
}

cli::Outcome measureFiles(const IoOptions& options, const BenchRoom& room, Report& report) {
    const cli::ScratchFolder folder;
    if (Status made = folder.check(); !made) {
        return made;
    }
    const Result<IoFigures> figures = measureIo(room, options.sizes, folder.path(), options.common.plan);
    if (!figures) {
        return cli::cannotDraw(figures.error());
    }
    Judged judged = judge(figures.value(), options);
    report.fields = {QStringLiteral("measured"), QStringLiteral("value"), QStringLiteral("ratio"),
                     QStringLiteral("at_most"), QStringLiteral("kept")};
    report.keys = report.fields.first(1);
    report.tables.push_back(std::move(judged.table));
    report.records = std::move(judged.records);
    return options.strict && !judged.allKept
               ? cli::differs({"A limit is not kept.", "bench io", "The column \"kept\" says which."})
               : cli::Outcome(Done{});
}

/// How many faces of so many bytes an import takes, in round numbers.
int mostImported(double bytesPerFace) {
    constexpr double kRound = 100'000.0;
    const double most = static_cast<double>(usualImportMemory()) / bytesPerFace;
    return static_cast<int>(std::clamp(std::floor(most / kRound) * kRound, kRound, double{kMostFaces}));
}

int runIo(Invocation& given) {
    IoOptions options;
    options.common = takeMeasuringOptions(given);
    takeSizeInto(options.common, given);
    options.sizes.quads = takeCount(given, "quads", 1, mostImported(kImportedPerQuad));
    options.sizes.plyTriangles = takeCount(given, "triangles", 0, mostImported(kImportedPerPlyTriangle));
    options.sizes.width = options.common.width;
    options.sizes.height = options.common.height;
    options.strict = given.isSet("strict");
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    for (const auto& [bytes, option] :
         {std::pair{kBytesPerQuad * options.sizes.quads, "--quads"},
          std::pair{kBytesPerPlyTriangle * options.sizes.plyTriangles, "--triangles"}}) {
        if (const QString why = whyItDoesNotFit(bytes); !why.isEmpty()) {
            return cli::finish(Error{"This is left out: " + why.toStdString() + ".", option,
                                     std::string("Ask for fewer ") + option + "."});
        }
    }
    return cli::finish(
        runBenchmark(QStringLiteral("io"), options.common, true,
                     [&](BenchRoom& room, Report& report) { return measureFiles(options, room, report); }));
}

}  // namespace

cli::Verb ioVerb() {
    return {{.name = QStringLiteral("bench io"),
             .files = {},
             .about = QStringLiteral("opening and exporting large files, next to other programs; memory"),
             .description =
                 QStringLiteral("Measures opening and exporting large mesh files, next to tinyobjloader, "
                                "Assimp and cp. Creates the files in the folder for temporary files."),
             .options =
                 QList<UsageOption>{
                     valueOption("quads", "N",
                                 QStringLiteral("Faces of the OBJ file; K is a thousand, M a "
                                                "million."),
                                 QStringLiteral("2M")),
                     valueOption("triangles", "N", QStringLiteral("Faces of the PLY file; 0: none."),
                                 QStringLiteral("10M")),
                     sizeOption(), strictOption(QStringLiteral("a limit"))} +
                 measuringOptions(),
             .examples = {{QStringLiteral("Measure small files with a few samples."),
                           QStringLiteral("hitscope-cli bench io --quick --quads 1K --triangles 0 --size "
                                          "320x180")}}},
            runIo};
}

}  // namespace hitscope::bench
