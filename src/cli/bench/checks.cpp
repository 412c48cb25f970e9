// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/checks.h"

#include <algorithm>
#include <string_view>

#include "cli/bench/arrival.h"
#include "cli/bench/history.h"
#include "cli/bench/hit_size.h"
#include "cli/bench/modes_scene.h"
#include "cli/bench/paper_row.h"
#include "cli/bench/physics_cost.h"

namespace hitscope::bench {

namespace {

using Method = HitFigure::Method;

constexpr int kPaperSphere = 7938;
constexpr std::uint32_t kSeed = 1;

Result<PipelineKind> pipelineOf(std::string_view key) {
    for (const PipelineTraits& traits : allPipelines()) {
        if (traits.key == key) {
            return traits.kind;
        }
    }
    return Error{"There is no pipeline \"" + std::string(key) + "\".", "", ""};
}

/// What the figures' methods have been measured at; an error where one has not.
Result<double> ratioOf(const HitFigure* a, const HitFigure* b, double times = 1.0) {
    if (a == nullptr || b == nullptr) {
        return Error{"It could not be measured here.", "", ""};
    }
    return times * timeRatio(a->hits, b->hits);
}

/// Several sizes measured together, so that their ratio is of one run.
Result<std::vector<std::vector<HitFigure>>> measureSizes(const BenchRoom& room, const std::vector<int>& sizes,
                                                         const HitOptions& options, const Plan& plan) {
    std::vector<std::unique_ptr<HitSizeBench>> benches;
    std::vector<Variant> variants;
    std::vector<std::size_t> ends;
    for (const int vertices : sizes) {
        room.say(
            QStringLiteral("making a sphere of %1 vertices").arg(grouped(static_cast<qulonglong>(vertices))));
        Result<std::unique_ptr<HitSizeBench>> bench = HitSizeBench::create(room, vertices, options);
        if (!bench) {
            return bench.error();
        }
        if (!bench.value()->notes().isEmpty()) {
            return Error{bench.value()->notes().join(QLatin1Char(' ')).toStdString(), "", ""};
        }
        for (Variant& variant : bench.value()->variants()) {
            variants.push_back(std::move(variant));
        }
        ends.push_back(variants.size());
        benches.push_back(std::move(bench).value());
    }
    Result<std::vector<Samples>> samples = room.measure(QStringLiteral("hits"), variants, plan);
    if (!samples) {
        return samples.error();
    }
    std::vector<std::vector<HitFigure>> figures;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < benches.size(); ++i) {
        figures.push_back(
            benches[i]->figures(std::span<const Samples>(samples.value()).subspan(begin, ends[i] - begin)));
        begin = ends[i];
    }
    return figures;
}

HitOptions hitOptions(PipelineKind kind, bool yardsticks) {
    HitOptions options;
    options.pipelines = {kind};
    options.yardsticks = yardsticks;
    options.seed = kSeed;
    return options;
}

/// A hit on 4,000,000 vertices over one on 8,000, with the read-back that every frame does.
Result<double> growth(std::string_view key, const BenchRoom& room, const Plan& plan) {
    Result<PipelineKind> kind = pipelineOf(key);
    if (!kind) {
        return kind.error();
    }
    Result<std::vector<std::vector<HitFigure>>> sizes =
        measureSizes(room, {kPaperSphere, 4000000}, hitOptions(kind.value(), false), plan);
    if (!sizes) {
        return sizes.error();
    }
    return ratioOf(findFigure(sizes.value()[1], Method::WithReadBack, kind.value()),
                   findFigure(sizes.value()[0], Method::WithReadBack, kind.value()));
}

/// Transform feedback over the paper's own way.
Result<double> overPaperWay(int vertices, const BenchRoom& room, const Plan& plan) {
    Result<std::vector<std::vector<HitFigure>>> sizes =
        measureSizes(room, {vertices}, hitOptions(PipelineKind::TransformFeedback, true), plan);
    if (!sizes) {
        return sizes.error();
    }
    return ratioOf(findFigure(sizes.value()[0], Method::WithReadBack),
                   findFigure(sizes.value()[0], Method::PaperFeedback));
}

/// A bound of a few hundredths needs more samples than one of a factor.
Plan longer(Plan plan) {
    plan.seconds *= 4.0;
    plan.mostSamples *= 4;
    return plan;
}

/// A thousand hits in one frame over one hit in a frame, with all that the session and its picture pay for
/// them.
Result<double> thousandHits(const BenchRoom& room, const Plan& plan) {
    Result<std::vector<Samples>> samples =
        measureArrivals(room, paperRowScene(kDefaultPaperRow), PipelineKind::TransformFeedback, {1, 1000},
                        kSeed, longer(plan));
    if (!samples) {
        return samples.error();
    }
    return timeRatio(samples.value()[1], samples.value()[0]);
}

Result<double> history(const BenchRoom& room, const Plan& plan) {
    HistoryOptions options;
    options.hits = {0, 10000};
    options.gentle = true;
    options.seed = kSeed;
    options.plan = longer(plan);
    Result<std::vector<HistoryFigure>> figures =
        measureHistories(room, paperRowScene(kDefaultPaperRow), options, QStringLiteral("history"));
    if (!figures) {
        return figures.error();
    }
    return timeRatio(figures.value()[1].frames, figures.value()[0].frames);
}

Result<std::vector<RowFigure>> measureRow(int row, std::vector<PipelineKind> pipelines, const BenchRoom& room,
                                          const Plan& plan) {
    RowBench bench(room, {std::move(pipelines), 10, kSeed, plan});
    if (!bench.unavailable().empty()) {
        return Error{bench.unavailable().begin()->second, "", ""};
    }
    return bench.measure(row, nullptr, QStringLiteral("row %1").arg(row + 1));
}

Result<double> culled(const BenchRoom& room, const Plan& plan) {
    Result<PipelineKind> kind = pipelineOf("uniform-array-culled");
    if (!kind) {
        return kind.error();
    }
    Result<std::vector<RowFigure>> figures =
        measureRow(kDefaultPaperRow, {PipelineKind::UniformArray, kind.value()}, room, plan);
    if (!figures) {
        return figures.error();
    }
    return timeRatio(findFigure(figures.value(), kind.value())->frames,
                     findFigure(figures.value(), PipelineKind::UniformArray)->frames);
}

/// The worst of the rows that have a high-polygon mesh.
Result<double> paperRowsRatio(const BenchRoom& room, const Plan& plan) {
    double worst = 0.0;
    for (int row = 0; row < static_cast<int>(paperRows().size()); ++row) {
        const PaperRow& counts = paperRows()[static_cast<std::size_t>(row)];
        if (counts.highPolyCubes + counts.highPolySpheres == 0) {
            continue;
        }
        Result<std::vector<RowFigure>> figures =
            measureRow(row, {PipelineKind::UniformArray, PipelineKind::TransformFeedback}, room, plan);
        if (!figures) {
            return figures.error();
        }
        worst =
            std::max(worst, timeRatio(findFigure(figures.value(), PipelineKind::TransformFeedback)->frames,
                                      findFigure(figures.value(), PipelineKind::UniformArray)->frames));
    }
    return worst;
}

Result<double> arrivingHits(const BenchRoom& room, const Plan& plan) {
    Result<std::vector<RowFigure>> figures =
        measureRow(kDefaultPaperRow, {PipelineKind::TransformFeedback}, room, longer(plan));
    if (!figures) {
        return figures.error();
    }
    return timeRatio(findFigure(figures.value(), PipelineKind::TransformFeedback, true)->frames,
                     findFigure(figures.value(), PipelineKind::TransformFeedback, false)->frames);
}

/// Of a collider's time a hit, the same number of vertices affected.
std::function<Result<double>(const BenchRoom&, const Plan&)> colliderGrowth(Samples PhysicsFigure::*samples) {
    return [samples](const BenchRoom& room, const Plan& plan) -> Result<double> {
        const Result<std::vector<PhysicsFigure>> figures =
            measureColliders(room, {physicsSphere(8000), physicsSphere(2000000)}, plan);
        if (!figures) {
            return figures.error();
        }
        return timeRatio(figures.value()[1].*samples, figures.value()[0].*samples);
    };
}

Result<double> projectiles(const BenchRoom& room, const Plan& plan) {
    const Result<std::vector<Samples>> frames = measureProjectileDrawing(room, plan);
    if (!frames) {
        return frames.error();
    }
    return timeRatio(frames.value()[1], frames.value()[0]);
}

std::vector<Check> makeChecks() {
    const auto growthOf = [](const char* key) {
        return [key](const BenchRoom& room, const Plan& plan) { return growth(key, room, plan); };
    };
    const auto paperWayAt = [](int vertices) {
        return [vertices](const BenchRoom& room, const Plan& plan) {
            return overPaperWay(vertices, room, plan);
        };
    };
    std::vector<Check> checks{
        {{"size-transform-feedback", "a hit on 4,000,000 vertices / on 7,938, transform feedback", 2.0,
          growthOf("transform-feedback")},
         {"size-compute", "the same, compute", 2.0, growthOf("compute")},
         {"size-reference", "the same, reference", 2.0, growthOf("reference")},
         {"history", "a frame with 10,000 hits in the history / with none, transform feedback", 1.03,
          history},
         {"culled", "a frame of uniform array, culled / of uniform array, 600 hits", 1.0 / 8.0, culled},
         {"paper-way-8k", "a hit on 7,938 vertices, transform feedback / the paper's own way", 1.0 / 10.0,
          paperWayAt(kPaperSphere)},
         {"paper-way-1m", "a hit on 1,000,000 vertices, transform feedback / the paper's own way",
          1.0 / 500.0, paperWayAt(1000000)},
         {"paper-rows",
          "a frame of transform feedback / of uniform array, the worst row with high-poly meshes", 1.0 / 20.0,
          paperRowsRatio},
         {"arriving-hits", "a frame with a hit every 10 / with none arriving, transform feedback", 1.05,
          arrivingHits},
         {"thousand-hits",
          "a frame's 1,000 hits / a frame's one hit, transform feedback, the paper's second row", 50.0,
          thousandHits},
         {"collider-update", "a collider taking on a hit, 2,000,000 triangles / 8,000", 3.0,
          colliderGrowth(&PhysicsFigure::dented)},
         {"hull-update", "the same, a dynamic target's with its hull", 3.0,
          colliderGrowth(&PhysicsFigure::dentedMoving)},
         {"projectiles", "a frame with 2,000 projectiles and their trails / with none", 2.0, projectiles}}};
    for (const ViewMode& mode : viewModes()) {
        if (&mode != &plainModeOf(mode)) {
            checks.push_back(
                {"mode-" + std::string(mode.key),
                 std::string("a frame in the mode / plain shading, 116,256 vertices: ") + mode.name,
                 mode.atMost,
                 [&mode](const BenchRoom& room, const Plan& plan) { return modeCost(room, plan, mode); }});
        }
    }
    return checks;
}

}  // namespace

std::span<const Check> allChecks() {
    static const std::vector<Check> kChecks = makeChecks();
    return kChecks;
}

}  // namespace hitscope::bench
