// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTextStream>
#include <algorithm>
#include <array>

#include "cli/bench/bench_command.h"
#include "cli/bench/paper_report.h"
#include "cli/bench/report_header.h"
#include "cli/command_line.h"

namespace hitscope::bench {

namespace {

struct TextureChoice {
    const char* key;
    int size;  ///< pixels a side; 0: none
};
constexpr std::array<TextureChoice, 4> kTextures{{{"none", 0}, {"1k", 1024}, {"2k", 2048}, {"4k", 4096}}};

struct PaperOptions {
    CommonOptions common;
    std::vector<TextureChoice> textures;
    std::vector<int> rows;  ///< indices into paperRows()
    int hitEvery = 10;
    bool tellsProgress = false;
};

QStringList paperNotes(const RowBench& bench) {
    QStringList notes{
        QStringLiteral(
            "All variants of a row show the same 600 hits, spread over the targets, with the paper's "
            "normals; they were measured in turn."),
        QStringLiteral(
            "Where hits arrive, a sample is the mean over the frames from one hit to the next. Range: "
            "slowest and fastest sample."),
        QStringLiteral(
            "Paper: A. Quercia, Real Time Graphics Programming, tables 1 and 2; L1 GeForce GTX 950M, "
            "L2 GeForce GTX 1650. All targets share one texture."),
        QStringLiteral(
            "The paper's way: as its section 2.2 says, all vertices of the target that is hit are captured, "
            "read back and uploaded for each hit. Hitscope's works on the vertices near the hit, on the "
            "GPU.")};
    for (const auto& [kind, why] : bench.unavailable()) {
        notes
            << QStringLiteral("%1 cannot run here: %2").arg(pipelineName(kind), QString::fromStdString(why));
    }
    return notes;
}

Status runPaper(const PaperOptions& options) {
    if (Status status = checkDestinations(options.common.destinations); !status) {
        return status;
    }
    Result<std::unique_ptr<BenchRoom>> room = BenchRoom::open(options.common.width, options.common.height);
    if (!room) {
        return room.error();
    }
    RowBench bench(*room.value(), {options.common.pipelines, options.hitEvery, options.common.seed,
                                   options.common.plan, true});
    std::vector<MeasuredRow> rows;
    const auto all = static_cast<double>(options.textures.size() * options.rows.size());
    if (options.tellsProgress) {
        room.value()->setTold([&rows, all](double part, const QString& what) {
            QTextStream(stderr) << "progress "
                                << QString::number((static_cast<double>(rows.size()) + part) / all, 'f', 4)
                                << ' ' << what << Qt::endl;
        });
    }
    for (const TextureChoice& texture : options.textures) {
        std::shared_ptr<const MaterialSet> materials;
        if (texture.size > 0) {
            Result<std::shared_ptr<const MaterialSet>> made = bench.makeTextures(texture.size);
            if (!made) {
                return made.error();
            }
            materials = made.value();
        }
        for (const int row : options.rows) {
            const QString what =
                QStringLiteral("row %1, textures %2").arg(row + 1).arg(QString::fromLatin1(texture.key));
            Result<std::vector<RowFigure>> figures = bench.measure(row, materials, what);
            if (!figures) {
                return figures.error();
            }
            rows.push_back({row, QString::fromLatin1(texture.key), std::move(figures).value()});
        }
    }
    Report report;
    report.benchmark = QStringLiteral("paper");
    report.header = reportHeader(*room.value(), options.common.width, options.common.height);
    report.notes = paperNotes(bench);
    addPaperRows(report, rows);
    return writeReport(report, options.common.destinations);
}

}  // namespace

int paperCommand(const QStringList& list) {
    Arguments arguments(
        QStringLiteral("Measures the frame rates of the paper's nine scenes, as in its tables 1 and 2, under "
                       "every pipeline."));
    addCommonOptions(arguments, true);
    arguments.addOption(QStringLiteral("textures"), QStringLiteral("On the targets: none, 1k, 2k, 4k."),
                        QStringLiteral("list"), QStringLiteral("none"));
    arguments.addOption(QStringLiteral("rows"), QStringLiteral("Rows of the tables."), QStringLiteral("list"),
                        QStringLiteral("1,2,3,4,5,6,7,8,9"));
    arguments.addOption(QStringLiteral("hit-every"),
                        QStringLiteral("Frames from one hit to the next; 0: none."), QStringLiteral("frames"),
                        QStringLiteral("10"));
    arguments.addFlag(QStringLiteral("progress"),
                      QStringLiteral("Lines \"progress 0.25 WHAT\" on the standard error, for programs."));
    parseBenchArguments(arguments, list);
    if (arguments.error().isEmpty() && arguments.wantsHelp()) {
        QTextStream(stdout) << arguments.help(QStringLiteral("paper"));
        return 0;
    }
    PaperOptions options;
    options.common = takeCommonOptions(arguments, true);
    options.hitEvery = arguments.wholeNumber(QStringLiteral("hit-every"), 0, 10000);
    options.tellsProgress = arguments.isSet(QStringLiteral("progress"));
    for (const int row :
         arguments.wholeNumbers(QStringLiteral("rows"), 1, static_cast<int>(paperRows().size()))) {
        options.rows.push_back(row - 1);
    }
    QStringList known;
    for (const TextureChoice& texture : kTextures) {
        known << QString::fromLatin1(texture.key);
    }
    const QStringList wanted = arguments.list(QStringLiteral("textures"), known);
    std::copy_if(kTextures.begin(), kTextures.end(), std::back_inserter(options.textures),
                 [&](const TextureChoice& texture) { return wanted.contains(QLatin1String(texture.key)); });
    if (!arguments.error().isEmpty()) {
        return cli::wrongUsage(arguments.error());
    }
    return cli::finish(runPaper(options));
}

}  // namespace hitscope::bench
