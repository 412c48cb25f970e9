// SPDX-License-Identifier: GPL-3.0-or-later
// What two thousand projectiles cost, and colliders that follow the dents.
#include <algorithm>
#include <utility>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/physics_cost.h"

namespace hitscope::bench {

namespace {

constexpr int kLeastTriangles = 500;  // on a coarser sphere not all projectiles strike in one step
constexpr int kMostTriangles = 20000000;
constexpr double kBytesPerTriangle = 400.0;  // of a mesh and the three colliders that are measured

struct PhysicsOptions {
    CommonOptions common;
    std::vector<int> triangles;
};

QString medianAndMost(const Samples& samples) {
    return QStringLiteral("%1 (%2)").arg(shortTime(samples.median()), shortTime(samples.most()));
}

void addSteps(Report& report, const std::vector<PhysicsFigure>& figures) {
    Table table;
    table.title =
        QStringLiteral("A physics step with %1 projectiles, median and longest").arg(grouped(kProjectiles));
    table.columns = {QStringLiteral("triangles"), QStringLiteral("in flight"),
                     QStringLiteral("all striking")};
    for (const PhysicsFigure& figure : figures) {
        table.rows.push_back(
            {grouped(figure.triangles), medianAndMost(figure.flying), medianAndMost(figure.striking)});
    }
    table.notes << QStringLiteral("all striking: each of them meets the target in that one step.");
    report.tables.push_back(table);
}

void addColliders(Report& report, const std::vector<PhysicsFigure>& figures) {
    Table table;
    table.title =
        QStringLiteral("A collider taking on a hit that reaches about %1 vertices").arg(kDentVertices);
    table.columns = {QStringLiteral("triangles"), QStringLiteral("static"), QStringLiteral("over the first"),
                     QStringLiteral("dynamic"), QStringLiteral("over the first")};
    for (const PhysicsFigure& figure : figures) {
        const auto over = [](const Samples& a, const Samples& b) {
            return QStringLiteral("x%1").arg(timeRatio(a, b), 0, 'f', 2);
        };
        table.rows.push_back({grouped(figure.triangles), shortTime(figure.dented.median()),
                              over(figure.dented, figures.front().dented),
                              shortTime(figure.dentedMoving.median()),
                              over(figure.dentedMoving, figures.front().dentedMoving)});
    }
    table.notes << QStringLiteral("dynamic: with its hull, and the step in which the hull follows.");
    report.tables.push_back(table);
}

void addDrawing(Report& report, const std::vector<Samples>& frames) {
    Table table;
    table.title = QStringLiteral("A frame of the paper's second row");
    table.columns = {QStringLiteral("projectiles"), QStringLiteral("frame"), QStringLiteral("over none")};
    for (std::size_t i = 0; i < frames.size(); ++i) {
        table.rows.push_back(
            {i == 0 ? QStringLiteral("none") : grouped(kProjectiles) + QStringLiteral(", with trails"),
             shortTime(frames[i].median()),
             QStringLiteral("x%1").arg(timeRatio(frames[i], frames[0]), 0, 'f', 2)});
    }
    report.tables.push_back(table);
}

void addRecords(Report& report, const std::vector<PhysicsFigure>& figures,
                const std::vector<Samples>& frames) {
    report.fields = {QStringLiteral("triangles"), QStringLiteral("measured"), QStringLiteral("samples"),
                     QStringLiteral("seconds_median"), QStringLiteral("seconds_most")};
    report.keys = report.fields.first(2);
    const auto add = [&report](const QJsonValue& triangles, const char* measured, const Samples& samples) {
        report.records.push_back({{QStringLiteral("triangles"), triangles},
                                  {QStringLiteral("measured"), QLatin1String(measured)},
                                  {QStringLiteral("samples"), static_cast<qint64>(samples.size())},
                                  {QStringLiteral("runs"), runsJson(samples)},
                                  {QStringLiteral("seconds_median"), samples.median()},
                                  {QStringLiteral("seconds_most"), samples.most()}});
    };
    for (const PhysicsFigure& figure : figures) {
        const auto triangles = static_cast<qint64>(figure.triangles);
        add(triangles, "step in flight", figure.flying);
        add(triangles, "step all striking", figure.striking);
        add(triangles, "collider", figure.dented);
        add(triangles, "collider and hull", figure.dentedMoving);
    }
    add({}, "frame without projectiles", frames[0]);
    add({}, "frame with projectiles", frames[1]);
}

/// Each of another size: what is asked for may come out alike.
std::vector<PreparedMesh> makeTargets(const PhysicsOptions& options, const BenchRoom& room, Report& report) {
    std::vector<PreparedMesh> meshes;
    for (const int triangles : options.triangles) {
        room.say(QStringLiteral("making a sphere of %1 triangles")
                     .arg(grouped(static_cast<qulonglong>(triangles))));
        PreparedMesh mesh = physicsSphere(triangles);
        const std::size_t corners = mesh.render->triangles.size();
        if (std::any_of(meshes.begin(), meshes.end(), [corners](const PreparedMesh& before) {
                return before.render->triangles.size() == corners;
            })) {
            report.notes << sameAgain(triangles, QStringLiteral("triangles"), corners / 3);
            continue;
        }
        meshes.push_back(std::move(mesh));
    }
    return meshes;
}

cli::Outcome measurePhysicsAll(const PhysicsOptions& options, const BenchRoom& room, Report& report) {
    const std::vector<PreparedMesh> meshes = makeTargets(options, room, report);
    const Result<std::vector<PhysicsFigure>> figures = measurePhysics(room, meshes, options.common.plan);
    if (!figures) {
        return figures.error();
    }
    const Result<std::vector<Samples>> frames = measureProjectileDrawing(room, options.common.plan);
    if (!frames) {
        return cli::cannotDraw(frames.error());
    }
    addSteps(report, figures.value());
    addColliders(report, figures.value());
    addDrawing(report, frames.value());
    addRecords(report, figures.value(), frames.value());
    return Done{};
}

int runPhysics(Invocation& given) {
    PhysicsOptions options;
    options.common = takeMeasuringOptions(given);
    takeSizeInto(options.common, given);
    options.triangles = takeCounts(given, "triangles", kLeastTriangles, kMostTriangles);
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    double bytes = 0.0;
    for (const int triangles : options.triangles) {
        bytes += kBytesPerTriangle * triangles;
    }
    if (const QString why = whyItDoesNotFit(bytes); !why.isEmpty()) {
        return cli::finish(
            Error{"This is left out: " + why.toStdString() + ".", "", "Ask for fewer --triangles."});
    }
    return cli::finish(runBenchmark(
        QStringLiteral("physics"), options.common, true,
        [&](BenchRoom& room, Report& report) { return measurePhysicsAll(options, room, report); }));
}

}  // namespace

cli::Verb physicsVerb() {
    return {
        {.name = QStringLiteral("bench physics"),
         .files = {},
         .about = QStringLiteral("steps and frames with 2,000 projectiles, colliders that follow the dents"),
         .description = QStringLiteral(
             "Measures physics steps and frames with 2,000 projectiles, and colliders that follow the "
             "dents."),
         .options = QList<UsageOption>{valueOption("triangles", "LIST",
                                                   QStringLiteral("Triangles of the targets; K is a "
                                                                  "thousand, M a million."),
                                                   QStringLiteral("8000,2M")),
                                       sizeOption()} +
                    measuringOptions(),
         .examples = {{QStringLiteral("Measure a small target with a few samples."),
                       QStringLiteral("hitscope-cli bench physics --quick --triangles 1K --size 320x180")}}},
        runPhysics};
}

}  // namespace hitscope::bench
