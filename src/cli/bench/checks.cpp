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

using Rows = Result<std::vector<CheckRow>>;

Rows oneRow(TimeRatio ratio) {
    return std::vector<CheckRow>{{{}, std::move(ratio)}};
}

std::string countText(int count) {
    return grouped(static_cast<qulonglong>(count)).toStdString();
}

/// What the figures' methods have been measured at; an error where one has not.
Result<TimeRatio> ratioOf(const HitFigure* a, const HitFigure* b) {
    if (a == nullptr || b == nullptr) {
        return Error{"It could not be measured here.", "", ""};
    }
    return timeRatioWithRounds(a->hits, b->hits);
}

struct SizeToMeasure {
    int vertices;
    HitOptions options;
};

/// Measured together, so that their ratio is of one run.
Result<std::vector<std::vector<HitFigure>>> measureSizes(const BenchRoom& room,
                                                         const std::vector<SizeToMeasure>& sizes,
                                                         const Plan& plan) {
    std::vector<std::unique_ptr<HitSizeBench>> benches;
    std::vector<Variant> variants;
    std::vector<std::size_t> ends;
    for (const auto& [vertices, options] : sizes) {
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

/// A hit on larger spheres over one on the paper's, with the read-back that every frame does.
Rows growth(PipelineKind kind, const BenchRoom& room, const Plan& plan) {
    const HitOptions options = hitOptions(kind, false);
    const std::vector<SizeToMeasure> wanted{
        {kPaperSphere, options}, {100000, options}, {1000000, options}, {4000000, options}};
    Result<std::vector<std::vector<HitFigure>>> sizes = measureSizes(room, wanted, plan);
    if (!sizes) {
        return sizes.error();
    }
    std::vector<CheckRow> rows;
    for (std::size_t i = 1; i < wanted.size(); ++i) {
        Result<TimeRatio> ratio = ratioOf(findFigure(sizes.value()[i], Method::WithReadBack, kind),
                                          findFigure(sizes.value()[0], Method::WithReadBack, kind));
        if (!ratio) {
            return ratio.error();
        }
        rows.push_back({countText(wanted[i].vertices) + " vertices", std::move(ratio).value()});
    }
    return rows;
}

/// Transform feedback over the paper's own way.
Rows overPaperWay(int vertices, const BenchRoom& room, const Plan& plan) {
    Result<std::vector<std::vector<HitFigure>>> sizes =
        measureSizes(room, {{vertices, hitOptions(PipelineKind::TransformFeedback, true)}}, plan);
    if (!sizes) {
        return sizes.error();
    }
    Result<TimeRatio> ratio = ratioOf(findFigure(sizes.value()[0], Method::WithReadBack),
                                      findFigure(sizes.value()[0], Method::PaperFeedback));
    return ratio ? oneRow(std::move(ratio).value()) : Rows(ratio.error());
}

/// A bound of a few hundredths needs more samples than one of a factor.
Plan longer(Plan plan) {
    plan.seconds *= 4.0;
    plan.mostSamples *= 4;
    return plan;
}

/// A thousand hits in one frame over one hit in a frame, with all that the session and its picture pay for
/// them.
Rows thousandHits(const BenchRoom& room, const Plan& plan) {
    Result<std::vector<Samples>> samples =
        measureArrivals(room, paperRowScene(kDefaultPaperRow), PipelineKind::TransformFeedback, {1, 1000},
                        kSeed, longer(plan));
    if (!samples) {
        return samples.error();
    }
    return oneRow(timeRatioWithRounds(samples.value()[1], samples.value()[0]));
}

/// Of each pipeline that keeps all hits and runs here.
Rows history(const BenchRoom& room, const Plan& plan) {
    std::vector<CheckRow> rows;
    for (const PipelineTraits& traits : allPipelines()) {
        const Result<std::unique_ptr<DeformationPipeline>> made = room.makePipeline(traits.kind);
        if (!made || made.value()->capacity().capacity) {
            continue;
        }
        HistoryOptions options;
        options.pipeline = traits.kind;
        options.hits = {0, 10000};
        options.gentle = true;
        options.seed = kSeed;
        options.plan = longer(plan);
        Result<std::vector<HistoryFigure>> figures =
            measureHistories(room, paperRowScene(kDefaultPaperRow), options, pipelineName(traits.kind));
        if (!figures) {
            return figures.error();
        }
        rows.push_back({std::string(traits.key),
                        timeRatioWithRounds(figures.value()[1].frames, figures.value()[0].frames)});
    }
    return rows;
}

Result<TimeRatio> besideFormApplied(PipelineKind kind, const BenchRoom& room, const Plan& plan) {
    constexpr int kAtOnce = 100;
    HitOptions alone = hitOptions(kind, false);
    alone.hitsAFrame = {kAtOnce};
    HitOptions beside = alone;
    beside.besideForm = true;
    Result<std::vector<std::vector<HitFigure>>> measured =
        measureSizes(room, {{kPaperSphere, alone}, {kPaperSphere, beside}}, longer(plan));
    if (!measured) {
        return measured.error();
    }
    return ratioOf(findFigure(measured.value()[1], Method::WithReadBack, kind, kAtOnce),
                   findFigure(measured.value()[0], Method::WithReadBack, kind, kAtOnce));
}

Result<TimeRatio> besideFormInArrays(PipelineKind kind, const BenchRoom& room, const Plan& plan) {
    HistoryOptions options;
    options.pipeline = kind;
    options.hits = {static_cast<int>(kPaperHits)};
    options.gentle = true;
    options.besideForm = true;
    options.seed = kSeed;
    options.plan = longer(plan);
    Result<std::vector<HistoryFigure>> figures =
        measureHistories(room, paperRowScene(kDefaultPaperRow), options, pipelineName(kind));
    if (!figures) {
        return figures.error();
    }
    return timeRatioWithRounds(figures.value()[1].frames, figures.value()[0].frames);
}

/// What one dent of another form costs those of the paper's beside it: where vertices are kept, a hundred
/// hits a frame; in uniform arrays, as many as they hold in each frame.
Rows besideForms(const BenchRoom& room, const Plan& plan) {
    std::vector<CheckRow> rows;
    for (const PipelineTraits& traits : allPipelines()) {
        const Result<std::unique_ptr<DeformationPipeline>> made = room.makePipeline(traits.kind);
        if (!made) {
            continue;
        }
        Result<TimeRatio> ratio = made.value()->capacity().capacity
                                      ? besideFormInArrays(traits.kind, room, plan)
                                      : besideFormApplied(traits.kind, room, plan);
        if (!ratio) {
            return ratio.error();
        }
        rows.push_back({std::string(traits.key), std::move(ratio).value()});
    }
    return rows;
}

/// Of the paper's rows, what `ratio` makes of each one's figures. `withHighPoly`: those alone that have a
/// high-polygon mesh.
Rows inPaperRows(const BenchRoom& room, const Plan& plan, const std::vector<PipelineKind>& pipelines,
                 bool withHighPoly, const std::function<TimeRatio(const std::vector<RowFigure>&)>& ratio) {
    std::vector<CheckRow> rows;
    for (int row = 0; row < static_cast<int>(paperRows().size()); ++row) {
        const PaperRow& counts = paperRows()[static_cast<std::size_t>(row)];
        if (withHighPoly && counts.highPolyCubes + counts.highPolySpheres == 0) {
            continue;
        }
        RowBench bench(room, {pipelines, 10, kSeed, plan});
        if (!bench.unavailable().empty()) {
            return Error{bench.unavailable().begin()->second, "", ""};
        }
        Result<std::vector<RowFigure>> figures =
            bench.measure(row, nullptr, QStringLiteral("row %1").arg(row + 1));
        if (!figures) {
            return figures.error();
        }
        rows.push_back({"row " + std::to_string(row + 1), ratio(figures.value())});
    }
    return rows;
}

/// A frame of this pipeline over one of the uniform array.
Rows overUniformArray(PipelineKind kind, const BenchRoom& room, const Plan& plan) {
    return inPaperRows(
        room, plan, {PipelineKind::UniformArray, kind}, true, [kind](const std::vector<RowFigure>& figures) {
            return timeRatioWithRounds(findFigure(figures, kind)->frames,
                                       findFigure(figures, PipelineKind::UniformArray)->frames);
        });
}

Rows arrivingHits(const BenchRoom& room, const Plan& plan) {
    return inPaperRows(room, longer(plan), {PipelineKind::TransformFeedback}, false,
                       [](const std::vector<RowFigure>& figures) {
                           return timeRatioWithRounds(
                               findFigure(figures, PipelineKind::TransformFeedback, true)->frames,
                               findFigure(figures, PipelineKind::TransformFeedback, false)->frames);
                       });
}

/// Of a collider's time a hit, the same number of vertices affected.
std::function<Rows(const BenchRoom&, const Plan&)> colliderGrowth(Samples PhysicsFigure::*samples) {
    return [samples](const BenchRoom& room, const Plan& plan) -> Rows {
        const std::vector<int> triangles{8000, 200000, 2000000};
        std::vector<PreparedMesh> spheres;
        for (const int count : triangles) {
            spheres.push_back(physicsSphere(count));
        }
        const Result<std::vector<PhysicsFigure>> figures = measureColliders(room, spheres, plan);
        if (!figures) {
            return figures.error();
        }
        std::vector<CheckRow> rows;
        for (std::size_t i = 1; i < triangles.size(); ++i) {
            rows.push_back({countText(triangles[i]) + " triangles",
                            timeRatioWithRounds(figures.value()[i].*samples, figures.value()[0].*samples)});
        }
        return rows;
    };
}

Rows projectiles(const BenchRoom& room, const Plan& plan) {
    const Result<std::vector<Samples>> frames = measureProjectileDrawing(room, plan);
    if (!frames) {
        return frames.error();
    }
    return oneRow(timeRatioWithRounds(frames.value()[1], frames.value()[0]));
}

constexpr PipelineKind kFeedback = PipelineKind::TransformFeedback;

Check sizeCheck(const char* name, const char* about, PipelineKind kind) {
    return {name,
            about,
            2.0,
            [kind](const BenchRoom& room, const Plan& plan) { return growth(kind, room, plan); },
            {kind}};
}

Check arrayCheck(const char* name, const char* about, double atMost, PipelineKind kind) {
    return {name,
            about,
            atMost,
            [kind](const BenchRoom& room, const Plan& plan) { return overUniformArray(kind, room, plan); },
            {PipelineKind::UniformArray, kind}};
}

Check paperWayCheck(const char* name, const char* about, double atMost, int vertices) {
    return {
        name,
        about,
        atMost,
        [vertices](const BenchRoom& room, const Plan& plan) { return overPaperWay(vertices, room, plan); },
        {kFeedback}};
}

Check modeCheck(const ViewMode& mode) {
    return {"mode-" + std::string(mode.key),
            std::string("a frame in the mode / plain shading, 116,256 vertices: ") + mode.name,
            mode.atMost,
            [&mode](const BenchRoom& room, const Plan& plan) -> Rows {
                Result<TimeRatio> cost = modeCost(room, plan, mode);
                return cost ? oneRow(std::move(cost).value()) : Rows(cost.error());
            },
            {kFeedback}};
}

std::vector<Check> makeChecks() {
    std::vector<Check> checks{
        {sizeCheck("size-transform-feedback",
                   "a hit on up to 4,000,000 vertices / on 7,938, transform feedback", kFeedback),
         sizeCheck("size-compute", "the same, compute", PipelineKind::Compute),
         sizeCheck("size-reference", "the same, reference", PipelineKind::Reference),
         {"history", "a frame with 10,000 hits in the history / with none, each pipeline that keeps all",
          1.03, history},
         {"beside-form", "hits of the paper's form beside one of another / alone, each pipeline", 1.25,
          besideForms},
         arrayCheck("culled",
                    "a frame of uniform array, culled / of uniform array, 600 hits, the paper's rows with "
                    "high-poly meshes",
                    1.0 / 8.0, PipelineKind::UniformArrayCulled),
         paperWayCheck("paper-way-8k", "a hit on 7,938 vertices, transform feedback / the paper's own way",
                       1.0 / 10.0, kPaperSphere),
         paperWayCheck("paper-way-1m",
                       "a hit on 1,000,000 vertices, transform feedback / the paper's own way", 1.0 / 500.0,
                       1000000),
         arrayCheck(
             "paper-rows",
             "a frame of transform feedback / of uniform array, the paper's rows with high-poly meshes",
             1.0 / 20.0, kFeedback),
         {"arriving-hits",
          "a frame with a hit every 10 / with none arriving, transform feedback, the paper's rows",
          1.05,
          arrivingHits,
          {kFeedback}},
         {"thousand-hits",
          "a frame's 1,000 hits / a frame's one hit, transform feedback, the paper's second row",
          50.0,
          thousandHits,
          {kFeedback}},
         {"collider-update", "a collider taking on a hit, up to 2,000,000 triangles / 8,000", 3.0,
          colliderGrowth(&PhysicsFigure::dented)},
         {"hull-update", "the same, a dynamic target's with its hull", 3.0,
          colliderGrowth(&PhysicsFigure::dentedMoving)},
         {"projectiles", "a frame with 2,000 projectiles and their trails / with none", 2.0, projectiles}}};
    for (const ViewMode& mode : viewModes()) {
        if (&mode != &plainModeOf(mode)) {
            checks.push_back(modeCheck(mode));
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
