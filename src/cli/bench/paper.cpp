// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTextStream>
#include <algorithm>
#include <array>
#include <iterator>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/paper_report.h"

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

/// Lines "progress 0.25 WHAT", of how much of all rows.
void tellProgress(BenchRoom& room, const std::vector<MeasuredRow>& rows, double all) {
    room.setTold([&rows, all](double part, const QString& what) {
        QTextStream(stderr) << "progress "
                            << QString::number((static_cast<double>(rows.size()) + part) / all, 'f', 4) << ' '
                            << what << Qt::endl;
    });
}

cli::Outcome measurePaper(const PaperOptions& options, BenchRoom& room, Report& report) {
    RowBench bench(
        room, {options.common.pipelines, options.hitEvery, options.common.seed, options.common.plan, true});
    std::vector<MeasuredRow> rows;
    if (options.tellsProgress) {
        tellProgress(room, rows, static_cast<double>(options.textures.size() * options.rows.size()));
    }
    for (const TextureChoice& texture : options.textures) {
        std::shared_ptr<const MaterialSet> materials;
        if (texture.size > 0) {
            Result<std::shared_ptr<const MaterialSet>> made = bench.makeTextures(texture.size);
            if (!made) {
                return cli::cannotDraw(made.error());
            }
            materials = made.value();
        }
        for (const int row : options.rows) {
            const QString what =
                QStringLiteral("row %1, textures %2").arg(row + 1).arg(QString::fromLatin1(texture.key));
            Result<std::vector<RowFigure>> figures = bench.measure(row, materials, what);
            if (!figures) {
                return cli::cannotDraw(figures.error());
            }
            rows.push_back({row, QString::fromLatin1(texture.key), std::move(figures).value()});
        }
    }
    room.setTold({});  // which looks at the rows
    report.notes = paperNotes(bench);
    addPaperRows(report, rows);
    return whatCameOf(report);
}

QStringList textureKeys() {
    QStringList keys;
    for (const TextureChoice& texture : kTextures) {
        keys << QString::fromLatin1(texture.key);
    }
    return keys;
}

int runPaper(Invocation& given) {
    PaperOptions options;
    options.common = takeCommonOptions(given);
    takeSizeInto(options.common, given);
    options.hitEvery = takeCount(given, "hit-every", 0, 10000);
    options.tellsProgress = given.isSet("progress");
    for (const int row : takeCounts(given, "rows", 1, static_cast<int>(paperRows().size()))) {
        options.rows.push_back(row - 1);
    }
    const QStringList wanted = takeWords(given, "textures");
    std::copy_if(kTextures.begin(), kTextures.end(), std::back_inserter(options.textures),
                 [&](const TextureChoice& texture) { return wanted.contains(QLatin1String(texture.key)); });
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    return cli::finish(
        runBenchmark(QStringLiteral("paper"), options.common, true,
                     [&](BenchRoom& room, Report& report) { return measurePaper(options, room, report); }));
}

}  // namespace

cli::Verb paperVerb() {
    return {
        {.name = QStringLiteral("bench paper"),
         .files = {},
         .about = QStringLiteral("the paper's tables 1 and 2: frame rates of its nine scenes"),
         .description = QStringLiteral(
             "Measures the frame rates of the paper's nine scenes, as in its tables 1 and 2, with every "
             "pipeline, and shows them next to the paper's own figures and ratios."),
         .options =
             QList<UsageOption>{
                 wordsOption("textures", textureKeys(), QStringLiteral("Textures on the targets."),
                             QStringLiteral("none")),
                 valueOption("rows", "LIST", QStringLiteral("Rows of the tables, 1 to 9."),
                             QStringLiteral("1,2,3,4,5,6,7,8,9")),
                 valueOption("hit-every", "N",
                             QStringLiteral("Frames between two hits that arrive; 0: none arrive."),
                             QStringLiteral("10")),
                 flagOption("progress",
                            QStringLiteral(
                                "Print lines \"progress 0.25 WHAT\" to the standard error, for programs.")),
                 sizeOption()} +
             commonOptions(),
         .examples = {{QStringLiteral(
                           "Measure the sixth row with the paper's two methods and a few samples."),
                       QStringLiteral("hitscope-cli bench paper --quick --rows 6 --size 160x90 "
                                      "--pipelines uniform-array,transform-feedback")}}},
        runPaper};
}

}  // namespace hitscope::bench
