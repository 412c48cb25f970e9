// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/window/window_cost.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <functional>

#include "cli/bench/bench_command.h"
#include "cli/bench/grid_files.h"
#include "cli/standard_streams.h"

namespace hitscope::bench {

namespace {

constexpr double kBytesPerVertex = 1500.0;     // of all that is in memory at once
constexpr double kLeastBytesPerVertex = 36.0;  // a position and two triangles

Samples samplesOf(const QJsonValue& values) {
    Samples samples;
    for (const auto& value : values.toArray()) {
        samples.add(value.toDouble());
    }
    return samples;
}

int quadsOf(int vertices) {
    const double side = std::sqrt(static_cast<double>(vertices)) - 1.0;  // quads
    return static_cast<int>(std::lround(side * side));
}

Result<QJsonObject> measureSheet(const WindowRoom& room, const QString& what, int vertices,
                                 const QStringList& options) {
    if (const QString why = whyItDoesNotFit(kBytesPerVertex * vertices); !why.isEmpty()) {
        return Error{"This is left out: " + why.toStdString() + ".", "", "Ask for fewer --vertices."};
    }
    const cli::ScratchFolder folder;
    if (Status made = folder.check(); !made) {
        return made.error();
    }
    const QString mesh = folder.file(QStringLiteral("sheet.obj"));
    if (Status written = writeGridObj(mesh, quadsOf(vertices)); !written) {
        return written.error();
    }
    return room.measure(what, mesh, options);
}

QString numberText(double number) {
    return QString::number(number, 'g', 12);
}

template <class Figures>
auto* findIn(const Figures& figures, const QString& measured) {
    const auto found = std::find_if(figures.rows.begin(), figures.rows.end(),
                                    [&](const auto& row) { return row.measured == measured; });
    return found == figures.rows.end() ? nullptr : &*found;
}

}  // namespace

std::vector<int> differentSheets(const std::vector<int>& vertices, QStringList& notes) {
    std::vector<int> kept;
    for (const int wanted : vertices) {
        const std::size_t made = gridVertices(quadsOf(wanted));
        if (std::any_of(kept.begin(), kept.end(),
                        [made](int before) { return gridVertices(quadsOf(before)) == made; })) {
            notes << sameAgain(wanted, QStringLiteral("vertices"), made);
            continue;
        }
        kept.push_back(wanted);
    }
    return kept;
}

const LatencyRow* findRow(const LatencyFigures& figures, const QString& measured) {
    return findIn(figures, measured);
}

const MemoryRow* findRow(const MemoryFigures& figures, const QString& measured) {
    return findIn(figures, measured);
}

Result<LatencyFigures> measureWindowLatency(const WindowRoom& room, const LatencyWish& wish) {
    const Result<QJsonObject> measured = measureSheet(
        room, QStringLiteral("latency"), wish.vertices,
        {QStringLiteral("--least"), QString::number(wish.plan.leastSamples), QStringLiteral("--most"),
         QString::number(wish.plan.mostSamples), QStringLiteral("--seconds"), numberText(wish.plan.seconds),
         QStringLiteral("--scattered"), QString::number(wish.scattered)});
    if (!measured) {
        return measured.error();
    }
    LatencyFigures figures;
    figures.renderer = measured.value();
    figures.vertices = static_cast<std::size_t>(figures.renderer[QStringLiteral("vertices")].toInteger());
    figures.moved = static_cast<std::size_t>(figures.renderer[QStringLiteral("moved")].toInteger());
    const QJsonArray viewport = figures.renderer[QStringLiteral("viewport")].toArray();
    figures.viewport = QSize(viewport.at(0).toInt(), viewport.at(1).toInt());
    for (const auto& value : figures.renderer[QStringLiteral("rows")].toArray()) {
        const QJsonObject row = value.toObject();
        figures.rows.push_back(
            {row[QStringLiteral("measured")].toString(), samplesOf(row[QStringLiteral("seconds")]),
             samplesOf(row[QStringLiteral("blocked")]), samplesOf(row[QStringLiteral("processor")])});
    }
    return figures;
}

Result<MemoryFigures> measureWindowMemory(const WindowRoom& room, const MemoryWish& wish) {
    const Result<QJsonObject> measured = measureSheet(room, QStringLiteral("memory"), wish.vertices,
                                                      {QStringLiteral("--hits"), QString::number(wish.hits)});
    if (!measured) {
        return measured.error();
    }
    MemoryFigures figures;
    figures.renderer = measured.value();
    figures.vertices = static_cast<std::size_t>(figures.renderer[QStringLiteral("vertices")].toInteger());
    figures.hits = static_cast<std::size_t>(figures.renderer[QStringLiteral("hits")].toInteger());
    figures.meshBytes = kLeastBytesPerVertex * static_cast<double>(figures.vertices);
    const auto rowOf = [&](const char* name, const QString& about, bool ofMesh) {
        const QString key = QLatin1String(name);
        for (const auto& value : figures.renderer[QStringLiteral("rows")].toArray()) {
            const QJsonObject row = value.toObject();
            if (row[QStringLiteral("measured")].toString() == key) {
                figures.rows.push_back({key, about, row[QStringLiteral("share")].toDouble(),
                                        row[QStringLiteral("resident")].toDouble(), ofMesh});
            }
        }
    };
    rowOf("start", QStringLiteral("at start"), false);
    rowOf("opened", QStringLiteral("mesh opened"), true);
    rowOf("first", QStringLiteral("after one hit"), true);
    rowOf("hits", QStringLiteral("after all hits"), true);
    rowOf("undone", QStringLiteral("all hits undone"), true);
    rowOf("closed", QStringLiteral("mesh closed"), false);
    // The first hit allocates what is needed once.
    const MemoryRow* first = findRow(figures, QStringLiteral("first"));
    const MemoryRow* after = findRow(figures, QStringLiteral("hits"));
    if (first != nullptr && after != nullptr && figures.hits > 1) {
        const auto hits = static_cast<double>(figures.hits - 1);
        figures.rows.push_back({QStringLiteral("hit"), QStringLiteral("growth per further hit"),
                                (after->share - first->share) / hits,
                                (after->resident - first->resident) / hits, false});
    }
    const double worker = figures.renderer[QStringLiteral("worker")].toDouble();
    figures.rows.push_back(
        {QStringLiteral("worker"), QStringLiteral("import process, at most"), worker, worker, false});
    return figures;
}

}  // namespace hitscope::bench
