// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTextStream>
#include <algorithm>
#include <array>

#include "cli/bench/bench_command.h"
#include "cli/bench/paper_figures.h"
#include "cli/bench/paper_row.h"
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
};

QString rate(double seconds) {
    return seconds > 0.0 ? shortNumber(1.0 / seconds) : QStringLiteral("-");
}

/// A row as measured, with one texture.
struct MeasuredRow {
    int row = 0;
    TextureChoice texture{};
    std::vector<RowFigure> figures;
};

QStringList rowCells(int row) {
    const PaperRow& counts = paperRows()[static_cast<std::size_t>(row)];
    return {QString::number(counts.lowPolyCubes), QString::number(counts.highPolyCubes),
            QString::number(counts.lowPolySpheres), QString::number(counts.highPolySpheres)};
}
const QStringList kRowColumns{QStringLiteral("LP cubes"), QStringLiteral("HP cubes"),
                              QStringLiteral("LP spheres"), QStringLiteral("HP spheres")};

/// The paper's own figures for a pipeline; null: it has none.
const PaperFigures* paperFigures(PipelineKind pipeline, int row) {
    const auto index = static_cast<std::size_t>(row);
    switch (pipeline) {
        case PipelineKind::UniformArray:
            return &paperTable1()[index];
        case PipelineKind::TransformFeedback:
            return &paperTable2()[index];
        default:
            return nullptr;
    }
}

class PaperReport {
public:
    PaperReport(const PaperOptions& options, std::vector<MeasuredRow> rows)
        : m_options(options), m_rows(std::move(rows)) {}

    void fill(Report& report) const {
        for (const TextureChoice& texture : m_options.textures) {
            for (const PipelineKind pipeline : m_options.common.pipelines) {
                addPipelineTable(report, pipeline, texture);
            }
            addRatioTable(report, texture);
        }
        report.fields = {QStringLiteral("row"),
                         QStringLiteral("lp_cubes"),
                         QStringLiteral("hp_cubes"),
                         QStringLiteral("lp_spheres"),
                         QStringLiteral("hp_spheres"),
                         QStringLiteral("texture"),
                         QStringLiteral("pipeline"),
                         QStringLiteral("hits_present"),
                         QStringLiteral("hit_every"),
                         QStringLiteral("samples"),
                         QStringLiteral("fps_median"),
                         QStringLiteral("fps_low"),
                         QStringLiteral("fps_high"),
                         QStringLiteral("paper_l1"),
                         QStringLiteral("paper_l2"),
                         QStringLiteral("fps_ratio_to_uniform_array"),
                         QStringLiteral("time_ratio_to_no_hits")};
        for (const MeasuredRow& row : m_rows) {
            for (const RowFigure& figure : row.figures) {
                report.records.push_back(record(row, figure));
            }
        }
    }

private:
    static QString tableTitle(PipelineKind pipeline) {
        if (pipeline == PipelineKind::UniformArray) {
            return QStringLiteral("Table 1: ");
        }
        return pipeline == PipelineKind::TransformFeedback ? QStringLiteral("Table 2: ") : QString();
    }

    void addPipelineTable(Report& report, PipelineKind pipeline, const TextureChoice& texture) const {
        Table table;
        table.columns = kRowColumns;
        table.columns << QStringLiteral("FPS median") << QStringLiteral("(range)");
        QString hits;
        for (const MeasuredRow& row : m_rows) {
            const RowFigure* figure =
                row.texture.size == texture.size ? findFigure(row.figures, pipeline) : nullptr;
            if (figure == nullptr) {
                continue;
            }
            QStringList cells = rowCells(row.row);
            cells << rate(figure->frames.median())
                  << QStringLiteral("(%1-%2)").arg(rate(figure->frames.most()), rate(figure->frames.least()));
            if (const PaperFigures* paper = paperFigures(pipeline, row.row)) {
                cells << QString::fromLatin1(paper->l1) << QString::fromLatin1(paper->l2);
            }
            table.rows.push_back(cells);
            hits = figure->hitEvery > 0 ? QStringLiteral("%1 hits present, another every %2 frames")
                                              .arg(figure->hitsKept)
                                              .arg(figure->hitEvery)
                                        : QStringLiteral("%1 hits present").arg(figure->hitsKept);
        }
        if (table.rows.empty()) {
            return;
        }
        if (paperFigures(pipeline, 0) != nullptr) {
            table.columns << QStringLiteral("paper L1") << QStringLiteral("paper L2");
        }
        table.title = tableTitle(pipeline) + pipelineName(pipeline) + QStringLiteral("; ") + hits +
                      QStringLiteral("; textures: ") + QString::fromLatin1(texture.key);
        report.tables.push_back(table);
    }

    void addRatioTable(Report& report, const TextureChoice& texture) const {
        Table table;
        table.title = QStringLiteral("Frame rate over that of uniform array, and cost of hits; textures: ") +
                      QString::fromLatin1(texture.key);
        table.columns = kRowColumns;
        for (const PipelineKind pipeline : m_options.common.pipelines) {
            if (pipeline != PipelineKind::UniformArray) {
                table.columns << pipelineName(pipeline);
            }
        }
        table.columns << QStringLiteral("hits / none");
        for (const MeasuredRow& row : m_rows) {
            if (row.texture.size != texture.size) {
                continue;
            }
            QStringList cells = rowCells(row.row);
            for (const PipelineKind pipeline : m_options.common.pipelines) {
                if (pipeline != PipelineKind::UniformArray) {
                    const RowFigure* figure = findFigure(row.figures, pipeline);
                    const double ratio = figure != nullptr ? overUniformArray(row, *figure) : 0.0;
                    cells << (ratio > 0.0 ? QStringLiteral("x%1").arg(shortNumber(ratio))
                                          : QStringLiteral("-"));
                }
            }
            const RowFigure* hits = findFigure(row.figures, PipelineKind::TransformFeedback, true);
            const double cost = hits != nullptr ? overNoHits(row, *hits) : 0.0;
            cells << (cost > 0.0 ? QString::number(cost, 'f', 3) : QStringLiteral("-"));
            table.rows.push_back(cells);
        }
        table.notes << QStringLiteral(
            "hits / none: frame time of transform feedback with hits arriving over "
            "that with none arriving.");
        report.tables.push_back(table);
    }

    /// Frame rate over that of the uniform array in this row; 0: not measured.
    static double overUniformArray(const MeasuredRow& row, const RowFigure& figure) {
        const RowFigure* base = findFigure(row.figures, PipelineKind::UniformArray);
        return base != nullptr ? timeRatio(base->frames, figure.frames) : 0.0;
    }
    /// Frame time over that without hits arriving; 0: not measured, or none arrive.
    static double overNoHits(const MeasuredRow& row, const RowFigure& figure) {
        const RowFigure* base = findFigure(row.figures, figure.pipeline, false);
        return base != nullptr && figure.hitEvery > 0 ? timeRatio(figure.frames, base->frames) : 0.0;
    }

    static QJsonObject record(const MeasuredRow& row, const RowFigure& figure) {
        const PaperRow& counts = paperRows()[static_cast<std::size_t>(row.row)];
        const PaperFigures* paper = paperFigures(figure.pipeline, row.row);
        const auto orNull = [](double value) { return value > 0.0 ? QJsonValue(value) : QJsonValue(); };
        return {{QStringLiteral("row"), row.row + 1},
                {QStringLiteral("lp_cubes"), counts.lowPolyCubes},
                {QStringLiteral("hp_cubes"), counts.highPolyCubes},
                {QStringLiteral("lp_spheres"), counts.lowPolySpheres},
                {QStringLiteral("hp_spheres"), counts.highPolySpheres},
                {QStringLiteral("texture"), QString::fromLatin1(row.texture.key)},
                {QStringLiteral("pipeline"), pipelineKey(figure.pipeline)},
                {QStringLiteral("hits_present"), static_cast<qint64>(figure.hitsKept)},
                {QStringLiteral("hit_every"), figure.hitEvery},
                {QStringLiteral("samples"), static_cast<qint64>(figure.frames.size())},
                {QStringLiteral("fps_median"), 1.0 / figure.frames.median()},
                {QStringLiteral("fps_low"), 1.0 / figure.frames.most()},
                {QStringLiteral("fps_high"), 1.0 / figure.frames.least()},
                {QStringLiteral("paper_l1"), paper != nullptr ? QString::fromLatin1(paper->l1) : QString()},
                {QStringLiteral("paper_l2"), paper != nullptr ? QString::fromLatin1(paper->l2) : QString()},
                {QStringLiteral("fps_ratio_to_uniform_array"), orNull(overUniformArray(row, figure))},
                {QStringLiteral("time_ratio_to_no_hits"), orNull(overNoHits(row, figure))}};
    }

    const PaperOptions& m_options;
    std::vector<MeasuredRow> m_rows;
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
            "L2 GeForce GTX 1650. All targets share one texture.")};
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
    RowBench bench(*room.value(),
                   {options.common.pipelines, options.hitEvery, options.common.seed, options.common.plan});
    std::vector<MeasuredRow> rows;
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
            rows.push_back({row, texture, std::move(figures).value()});
        }
    }
    Report report;
    report.benchmark = QStringLiteral("paper");
    report.header = reportHeader(options.common.width, options.common.height);
    report.notes = paperNotes(bench);
    PaperReport(options, std::move(rows)).fill(report);
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
    parseBenchArguments(arguments, list);
    if (arguments.error().isEmpty() && arguments.wantsHelp()) {
        QTextStream(stdout) << arguments.help();
        return 0;
    }
    PaperOptions options;
    options.common = takeCommonOptions(arguments, true);
    options.hitEvery = arguments.wholeNumber(QStringLiteral("hit-every"), 0, 10000);
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
