// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/hit_size.h"

namespace hitscope::bench {

namespace {

using Method = HitFigure::Method;

struct HitCommandOptions {
    CommonOptions common;
    HitOptions hits;
    std::vector<int> vertices;
};

/// What was measured on one size.
struct MeasuredSize {
    std::size_t vertices = 0;
    DeformationConstants constants;
    std::vector<HitFigure> figures;
};

QString methodName(const HitFigure& figure) {
    switch (figure.method) {
        case Method::Pipeline:
            return pipelineName(figure.pipeline);
        case Method::WithReadBack:
            return pipelineName(figure.pipeline) + QStringLiteral(", CPU follows");
        case Method::PaperFeedback:
            return QStringLiteral("The paper's own way");
        case Method::Copy:
            return QStringLiteral("memcpy");
    }
    return {};
}

QString methodKey(const HitFigure& figure) {
    switch (figure.method) {
        case Method::PaperFeedback:
            return QStringLiteral("paper-own-way");
        case Method::Copy:
            return QStringLiteral("memcpy");
        default:
            return pipelineKey(figure.pipeline);
    }
}

/// How many times as long the yardstick takes; 0: not measured.
double yardstickOver(const std::vector<HitFigure>& figures, Method yardstick, const HitFigure& figure) {
    const HitFigure* measure = findFigure(figures, yardstick);
    return measure != nullptr ? timeRatio(measure->hits, figure.hits) : 0.0;
}

/// How many times as long it takes as the physical limit; 0: not measured.
double overCopy(const std::vector<HitFigure>& figures, const HitFigure& figure) {
    const HitFigure* copy = findFigure(figures, Method::Copy);
    return copy != nullptr ? timeRatio(figure.hits, copy->hits) : 0.0;
}

QString times(double ratio) {
    return ratio > 0.0 ? QStringLiteral("x%1").arg(shortNumber(ratio)) : QStringLiteral("-");
}

Table tableOf(const MeasuredSize& size) {
    Table table;
    table.title =
        QStringLiteral("Sphere of %1 vertices; a hit reaches %2 m")
            .arg(grouped(size.vertices), shortNumber(static_cast<double>(size.constants.maxDistance)));
    table.columns = {QStringLiteral("method"),     QStringLiteral("hits a frame"),
                     QStringLiteral("affected"),   QStringLiteral("a hit"),
                     QStringLiteral("(range)"),    QStringLiteral("paper's way takes"),
                     QStringLiteral("over memcpy")};
    for (const HitFigure& figure : size.figures) {
        table.rows.push_back(
            {methodName(figure), grouped(static_cast<qulonglong>(figure.hitsAFrame)),
             QString::number(figure.affected, 'f', 1), shortTime(figure.hits.median()),
             QStringLiteral("(%1-%2)").arg(shortTime(figure.hits.least()), shortTime(figure.hits.most())),
             times(yardstickOver(size.figures, Method::PaperFeedback, figure)),
             times(overCopy(size.figures, figure))});
    }
    return table;
}

/// Each method's time a hit over that on the first size, with so many hits a frame where a method has those.
Table growthTable(const std::vector<MeasuredSize>& sizes, int hitsAFrame) {
    Table table;
    table.title = QStringLiteral("Time a hit over that on %1 vertices, %2 a frame")
                      .arg(grouped(sizes.front().vertices),
                           hitsAFrame == 1
                               ? QStringLiteral("one hit")
                               : QStringLiteral("%1 hits").arg(grouped(static_cast<qulonglong>(hitsAFrame))));
    table.columns << QStringLiteral("method");
    for (const MeasuredSize& size : sizes) {
        table.columns << grouped(size.vertices);
    }
    for (const HitFigure& first : sizes.front().figures) {
        const bool isYardstick = first.method == Method::PaperFeedback || first.method == Method::Copy;
        if (!isYardstick && first.hitsAFrame != hitsAFrame) {
            continue;
        }
        QStringList cells{methodName(first)};
        for (const MeasuredSize& size : sizes) {
            const HitFigure* figure =
                findFigure(size.figures, first.method, first.pipeline, first.hitsAFrame);
            cells << times(figure != nullptr ? ratioOfMedians(figure->hits, first.hits) : 0.0);
        }
        table.rows.push_back(cells);
    }
    table.notes << QStringLiteral(
        "The sizes were measured one after the other: where the machine was slower meanwhile, that is in "
        "here too.");
    return table;
}

QJsonObject record(const MeasuredSize& size, const HitFigure& figure) {
    const auto orNull = [](double value) { return value > 0.0 ? QJsonValue(value) : QJsonValue(); };
    return {{QStringLiteral("vertices"), static_cast<qint64>(size.vertices)},
            {QStringLiteral("max_distance"), static_cast<double>(size.constants.maxDistance)},
            {QStringLiteral("method"), methodKey(figure)},
            {QStringLiteral("read_back"), figure.method == Method::WithReadBack},
            {QStringLiteral("hits_a_frame"), figure.hitsAFrame},
            {QStringLiteral("affected"), figure.affected},
            {QStringLiteral("samples"), static_cast<qint64>(figure.hits.size())},
            {QStringLiteral("hit_seconds_median"), figure.hits.median()},
            {QStringLiteral("hit_seconds_least"), figure.hits.least()},
            {QStringLiteral("hit_seconds_most"), figure.hits.most()},
            {QStringLiteral("runs"), runsJson(figure.hits)},
            {QStringLiteral("paper_way_over_it"),
             orNull(yardstickOver(size.figures, Method::PaperFeedback, figure))},
            {QStringLiteral("it_over_memcpy"), orNull(overCopy(size.figures, figure))}};
}

QStringList hitNotes() {
    return {QStringLiteral(
                "A sample is 100 hits or more all over the sphere, frame after frame, until the GPU is "
                "done; before it the sphere is made whole. Affected: vertices a hit moves, counted."),
            QStringLiteral(
                "Hits on finer spheres are smaller in all directions, so that they move as many vertices. "
                "CPU follows: what changed is read back as well, frame after frame as in the window, and a "
                "sample ends when all of it has arrived."),
            QStringLiteral(
                "The paper's own way: capture all vertices, read all back, replace the modified, upload "
                "all. memcpy: the affected vertices' 24 bytes each; nothing that moves them is faster."),
            QStringLiteral(
                "A uniform array only notes the hit; what the hit costs there, every frame costs: bench "
                "frame measures it.")};
}

/// Different numbers may stand for the same sphere.
bool isAmong(const std::vector<MeasuredSize>& sizes, std::size_t vertices) {
    return std::any_of(sizes.begin(), sizes.end(),
                       [vertices](const MeasuredSize& size) { return size.vertices == vertices; });
}

/// Nothing where that sphere is among those that were measured `before`.
Result<std::optional<MeasuredSize>> measureSize(const BenchRoom& room, int vertices,
                                                const HitCommandOptions& options,
                                                const std::vector<MeasuredSize>& before, QStringList& notes) {
    const QString what = QStringLiteral("%1 vertices").arg(grouped(static_cast<qulonglong>(vertices)));
    room.say(what + QStringLiteral(": making the sphere"));
    Result<std::unique_ptr<HitSizeBench>> bench = HitSizeBench::create(room, vertices, options.hits);
    if (!bench) {
        return bench.error();
    }
    if (isAmong(before, bench.value()->vertexCount())) {
        notes << sameAgain(vertices, QStringLiteral("vertices"), bench.value()->vertexCount());
        return std::optional<MeasuredSize>();
    }
    notes << bench.value()->notes();
    Result<std::vector<Samples>> samples = room.measure(what, bench.value()->variants(), options.common.plan);
    if (!samples) {
        return samples.error();
    }
    return std::optional(MeasuredSize{bench.value()->vertexCount(), bench.value()->constants(),
                                      bench.value()->figures(samples.value())});
}

cli::Outcome measureHits(const HitCommandOptions& options, const BenchRoom& room, Report& report) {
    report.fields = {QStringLiteral("vertices"),
                     QStringLiteral("max_distance"),
                     QStringLiteral("method"),
                     QStringLiteral("read_back"),
                     QStringLiteral("hits_a_frame"),
                     QStringLiteral("affected"),
                     QStringLiteral("samples"),
                     QStringLiteral("hit_seconds_median"),
                     QStringLiteral("hit_seconds_least"),
                     QStringLiteral("hit_seconds_most"),
                     QStringLiteral("paper_way_over_it"),
                     QStringLiteral("it_over_memcpy")};
    report.keys = {QStringLiteral("vertices"), QStringLiteral("method"), QStringLiteral("read_back"),
                   QStringLiteral("hits_a_frame")};
    report.along = QStringLiteral("vertices");
    report.notes = hitNotes();
    std::vector<MeasuredSize> sizes;
    for (const int vertices : options.vertices) {
        Result<std::optional<MeasuredSize>> measured =
            measureSize(room, vertices, options, sizes, report.notes);
        if (!measured) {
            report.notes << QString::fromStdString(measured.error().message());
        } else if (measured.value()) {
            const MeasuredSize& size = sizes.emplace_back(std::move(*measured.value()));
            report.tables.push_back(tableOf(size));
            for (const HitFigure& figure : size.figures) {
                report.records.push_back(record(size, figure));
            }
        }
    }
    if (sizes.size() > 1) {
        report.tables.push_back(growthTable(sizes, options.hits.hitsAFrame.front()));
    }
    return whatCameOf(report);
}

int runHit(Invocation& given) {
    HitCommandOptions options;
    options.common = takeCommonOptions(given);
    options.vertices = takeCounts(given, "vertices", 8, 20000000);
    options.hits.pipelines = options.common.pipelines;
    options.hits.affected = given.number("affected", 1.0, 1e6);
    options.hits.hitsAFrame = takeCounts(given, "hits-a-frame", 1, 10000);
    options.hits.seed = options.common.seed;
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    return cli::finish(
        runBenchmark(QStringLiteral("hit"), options.common, false,
                     [&](BenchRoom& room, Report& report) { return measureHits(options, room, report); }));
}

}  // namespace

cli::Verb hitVerb() {
    return {{.name = QStringLiteral("bench hit"),
             .files = {},
             .about = QStringLiteral("time of a hit over the size of the mesh"),
             .description = QStringLiteral("Measures the cost of a hit on spheres of different sizes, next "
                                           "to the paper's method and memcpy."),
             .options =
                 QList<UsageOption>{
                     valueOption("vertices", "LIST",
                                 QStringLiteral("Sizes, measured one after the other; K is a thousand, M a "
                                                "million."),
                                 QStringLiteral("7938,100K,1M,4M,10M")),
                     valueOption("affected", "NUMBER",
                                 QStringLiteral("Approximate number of vertices that a hit moves."),
                                 QStringLiteral("80")),
                     valueOption("hits-a-frame", "LIST", QStringLiteral("Numbers of hits per frame."),
                                 QStringLiteral("1,10,100,1000"))} +
                 commonOptions(),
             .examples = {{QStringLiteral("Measure a hit on two sizes with a few samples, as JSON."),
                           QStringLiteral("hitscope-cli bench hit --quick --vertices 1K,8K --hits-a-frame 1 "
                                          "--json")}}},
            runHit};
}

}  // namespace hitscope::bench
