// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/paper_report.h"

#include "cli/bench/paper_figures.h"

namespace hitscope::bench {

namespace {

QString rate(double seconds) {
    return seconds > 0.0 ? shortNumber(1.0 / seconds) : QStringLiteral("-");
}

QStringList rowCells(int row) {
    const PaperRow& counts = paperRows()[static_cast<std::size_t>(row)];
    return {QString::number(counts.lowPolyCubes), QString::number(counts.highPolyCubes),
            QString::number(counts.lowPolySpheres), QString::number(counts.highPolySpheres)};
}

QStringList rowColumns() {
    return {QStringLiteral("low-poly cubes"), QStringLiteral("high-poly cubes"),
            QStringLiteral("low-poly spheres"), QStringLiteral("high-poly spheres")};
}

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

QString tableTitle(PipelineKind pipeline) {
    if (pipeline == PipelineKind::UniformArray) {
        return QStringLiteral("Table 1: ") + pipelineName(pipeline);
    }
    return (pipeline == PipelineKind::TransformFeedback ? QStringLiteral("Table 2: ") : QString()) +
           pipelineName(pipeline);
}

QString hitsText(const RowFigure& figure) {
    return figure.hitEvery > 0 ? QStringLiteral("%1 hits present, another every %2 frames")
                                     .arg(figure.hitsKept)
                                     .arg(figure.hitEvery)
                               : QStringLiteral("%1 hits present").arg(figure.hitsKept);
}

/// Frame rate over that of the uniform array in this row; 0: not measured.
double overUniformArray(const MeasuredRow& row, const RowFigure& figure) {
    const RowFigure* base = findFigure(row.figures, PipelineKind::UniformArray);
    return base != nullptr ? timeRatio(base->frames, figure.frames) : 0.0;
}

/// The paper's two methods against one another, on one of its laptops.
QString paperRatioOf(int row, const char* PaperFigures::*laptop) {
    const auto index = static_cast<std::size_t>(row);
    return paperRatio(paperTable2()[index].*laptop, paperTable1()[index].*laptop);
}

/// Frame time over that without hits arriving; 0: not measured, or none arrive.
double overNoHits(const MeasuredRow& row, const RowFigure& figure) {
    const RowFigure* base = findFigure(row.figures, figure.pipeline, false);
    return base != nullptr && figure.hitEvery > 0 ? timeRatio(figure.frames, base->frames) : 0.0;
}

using Rows = std::vector<const MeasuredRow*>;

/// The pipelines of a row, in their order, each once.
std::vector<PipelineKind> pipelinesOf(const MeasuredRow& row) {
    std::vector<PipelineKind> pipelines;
    for (const RowFigure& figure : row.figures) {
        if (pipelines.empty() || pipelines.back() != figure.pipeline) {
            pipelines.push_back(figure.pipeline);
        }
    }
    return pipelines;
}

QString rangeText(const RowFigure& figure) {
    return QStringLiteral("(%1-%2)").arg(rate(figure.frames.most()), rate(figure.frames.least()));
}

Table pipelineTable(const Rows& rows, PipelineKind pipeline) {
    Table table;
    const bool hasPapersWay =
        pipeline == PipelineKind::TransformFeedback && findPapersWay(rows.front()->figures) != nullptr;
    table.columns = rowColumns();
    if (hasPapersWay) {
        table.columns << QStringLiteral("the paper's way, FPS") << QStringLiteral("(range)")
                      << QStringLiteral("Hitscope's, FPS") << QStringLiteral("(range)");
    } else {
        table.columns << QStringLiteral("FPS median") << QStringLiteral("(range)");
    }
    if (paperFigures(pipeline, 0) != nullptr) {
        table.columns << QStringLiteral("paper L1") << QStringLiteral("paper L2");
    }
    for (const MeasuredRow* row : rows) {
        const RowFigure& figure = *findFigure(row->figures, pipeline);
        QStringList cells = rowCells(row->row);
        if (hasPapersWay) {
            const RowFigure& papers = *findPapersWay(row->figures);
            cells << rate(papers.frames.median()) << rangeText(papers);
        }
        cells << rate(figure.frames.median()) << rangeText(figure);
        if (const PaperFigures* paper = paperFigures(pipeline, row->row)) {
            cells << QString::fromLatin1(paper->l1) << QString::fromLatin1(paper->l2);
        }
        table.rows.push_back(cells);
        table.title =
            QStringLiteral("%1; %2; textures: %3").arg(tableTitle(pipeline), hitsText(figure), row->texture);
    }
    return table;
}

QString timesText(double ratio) {
    return ratio > 0.0 ? QStringLiteral("x%1").arg(shortNumber(ratio)) : QStringLiteral("-");
}

QString costText(const MeasuredRow& row, const RowFigure* hits) {
    const double cost = hits != nullptr ? overNoHits(row, *hits) : 0.0;
    return cost > 0.0 ? QString::number(cost, 'f', 3) : QStringLiteral("-");
}

Table ratioTable(const Rows& rows, const std::vector<PipelineKind>& pipelines) {
    Table table;
    table.title =
        QStringLiteral("Frame rate over that of the uniform array, and what hits cost; textures: ") +
        rows.front()->texture;
    const bool hasPapersWay = findPapersWay(rows.front()->figures) != nullptr;
    table.columns = rowColumns() << QStringLiteral("paper L1") << QStringLiteral("paper L2");
    if (hasPapersWay) {
        table.columns << QStringLiteral("the paper's way");
    }
    for (const PipelineKind pipeline : pipelines) {
        if (pipeline != PipelineKind::UniformArray) {
            table.columns << pipelineName(pipeline);
        }
    }
    table.columns << QStringLiteral("hits / none");
    if (hasPapersWay) {
        table.columns << QStringLiteral("the paper's way");
    }
    for (const MeasuredRow* row : rows) {
        const RowFigure* papers = findPapersWay(row->figures);
        QStringList cells = rowCells(row->row) << paperRatioOf(row->row, &PaperFigures::l1)
                                               << paperRatioOf(row->row, &PaperFigures::l2);
        if (papers != nullptr) {
            cells << timesText(overUniformArray(*row, *papers));
        }
        for (const PipelineKind pipeline : pipelines) {
            if (pipeline != PipelineKind::UniformArray) {
                cells << timesText(overUniformArray(*row, *findFigure(row->figures, pipeline)));
            }
        }
        cells << costText(*row, findFigure(row->figures, PipelineKind::TransformFeedback, true));
        if (papers != nullptr) {
            cells << costText(*row, papers);
        }
        table.rows.push_back(cells);
    }
    table.notes << QStringLiteral(
                       "paper L1, paper L2: its table 2 over its table 1, from the lowest over "
                       "the highest figure to the highest over the lowest.")
                << QStringLiteral(
                       "hits / none: frame time of transform feedback with hits arriving over "
                       "that with none arriving.");
    return table;
}

QJsonObject record(const MeasuredRow& row, const RowFigure& figure) {
    const PaperRow& counts = paperRows()[static_cast<std::size_t>(row.row)];
    const PaperFigures* paper = paperFigures(figure.pipeline, row.row);
    const bool feedback = figure.pipeline == PipelineKind::TransformFeedback;
    const auto orNull = [](double value) { return value > 0.0 ? QJsonValue(value) : QJsonValue(); };
    return {
        {QStringLiteral("row"), row.row + 1},
        {QStringLiteral("lp_cubes"), counts.lowPolyCubes},
        {QStringLiteral("hp_cubes"), counts.highPolyCubes},
        {QStringLiteral("lp_spheres"), counts.lowPolySpheres},
        {QStringLiteral("hp_spheres"), counts.highPolySpheres},
        {QStringLiteral("texture"), row.texture},
        {QStringLiteral("pipeline"), pipelineKey(figure.pipeline)},
        {QStringLiteral("hits_by"),
         figure.by == HitsBy::Paper ? QStringLiteral("paper") : QStringLiteral("pipeline")},
        {QStringLiteral("hits_present"), static_cast<qint64>(figure.hitsKept)},
        {QStringLiteral("hit_every"), figure.hitEvery},
        {QStringLiteral("samples"), static_cast<qint64>(figure.frames.size())},
        {QStringLiteral("runs"), runsJson(figure.frames)},
        {QStringLiteral("fps_median"), 1.0 / figure.frames.median()},
        {QStringLiteral("fps_low"), 1.0 / figure.frames.most()},
        {QStringLiteral("fps_high"), 1.0 / figure.frames.least()},
        {QStringLiteral("paper_l1"), paper != nullptr ? QString::fromLatin1(paper->l1) : QString()},
        {QStringLiteral("paper_l2"), paper != nullptr ? QString::fromLatin1(paper->l2) : QString()},
        {QStringLiteral("paper_ratio_l1"), feedback ? paperRatioOf(row.row, &PaperFigures::l1) : QString()},
        {QStringLiteral("paper_ratio_l2"), feedback ? paperRatioOf(row.row, &PaperFigures::l2) : QString()},
        {QStringLiteral("fps_ratio_to_uniform_array"), orNull(overUniformArray(row, figure))},
        {QStringLiteral("time_ratio_to_no_hits"), orNull(overNoHits(row, figure))}};
}

}  // namespace

void addPaperRows(Report& report, const std::vector<MeasuredRow>& rows) {
    report.fields = {QStringLiteral("row"),
                     QStringLiteral("lp_cubes"),
                     QStringLiteral("hp_cubes"),
                     QStringLiteral("lp_spheres"),
                     QStringLiteral("hp_spheres"),
                     QStringLiteral("texture"),
                     QStringLiteral("pipeline"),
                     QStringLiteral("hits_by"),
                     QStringLiteral("hits_present"),
                     QStringLiteral("hit_every"),
                     QStringLiteral("samples"),
                     QStringLiteral("fps_median"),
                     QStringLiteral("fps_low"),
                     QStringLiteral("fps_high"),
                     QStringLiteral("paper_l1"),
                     QStringLiteral("paper_l2"),
                     QStringLiteral("paper_ratio_l1"),
                     QStringLiteral("paper_ratio_l2"),
                     QStringLiteral("fps_ratio_to_uniform_array"),
                     QStringLiteral("time_ratio_to_no_hits")};
    report.keys = {QStringLiteral("row"), QStringLiteral("texture"), QStringLiteral("pipeline"),
                   QStringLiteral("hits_by"), QStringLiteral("hit_every")};

    QStringList textures;
    for (const MeasuredRow& row : rows) {
        textures << row.texture;
        for (const RowFigure& figure : row.figures) {
            report.records.push_back(record(row, figure));
        }
    }
    textures.removeDuplicates();
    for (const QString& texture : textures) {
        Rows same;
        for (const MeasuredRow& row : rows) {
            if (row.texture == texture) {
                same.push_back(&row);
            }
        }
        const std::vector<PipelineKind> pipelines = pipelinesOf(*same.front());
        for (const PipelineKind pipeline : pipelines) {
            report.tables.push_back(pipelineTable(same, pipeline));
        }
        report.tables.push_back(ratioTable(same, pipelines));
    }
}

}  // namespace hitscope::bench
