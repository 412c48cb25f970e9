// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/history.h"

#include <algorithm>
#include <utility>

#include "cli/bench/sphere.h"

namespace hitscope::bench {

namespace {

/// With gentle hits a vertex moves by less than a pixel, however many there are.
constexpr float kGentleMagnitude = 1e-6f;  // metres

DeformationConstants hitConstants(bool gentle) {
    DeformationConstants constants;
    if (gentle) {
        constants.maxMagnitude = kGentleMagnitude;
    }
    return constants;
}

double verticesOf(std::span<const TargetPlan> plans) {
    double vertices = 0.0;
    for (const TargetPlan& plan : plans) {
        vertices += static_cast<double>(plan.shape.render->vertices.size());
    }
    return vertices;
}

}  // namespace

StillScene paperRowScene(int row) {
    const std::vector<TargetPlan> plans = planPaperRow(paperRows()[static_cast<std::size_t>(row)]);
    return {[row](Session& session) { loadPaperRow(session, row); }, verticesOf(plans)};
}

StillScene sphereScene(int vertices) {
    const auto shape = std::make_shared<const PreparedMesh>(prepareMesh(makeSphere(vertices)));
    const auto made = static_cast<double>(shape->render->vertices.size());
    return {[shape](Session& session) { loadMesh(session, *shape); }, made};
}

Result<std::vector<HistoryFigure>> measureHistories(const BenchRoom& room, const StillScene& scene,
                                                    const HistoryOptions& options, const QString& what) {
    std::vector<HistoryFigure> figures;
    for (const int hits : options.hits) {
        figures.push_back({hits, false, 0, {}});
        if (options.besideForm && hits > 0) {
            figures.push_back({hits, true, 0, {}});
        }
    }
    const double bytes = kHistorySceneBytes * scene.vertices * static_cast<double>(figures.size());
    if (const QString why = whyItDoesNotFit(bytes); !why.isEmpty()) {
        return Error{"This is left out: " + why.toStdString() + ".", what.toStdString(),
                     "Ask for fewer numbers of hits at once."};
    }
    std::vector<std::unique_ptr<Scene>> scenes;
    std::vector<Variant> variants;
    for (const HistoryFigure& figure : figures) {
        const int hits = figure.hits;
        room.say(QStringLiteral("%1: making %2 hits").arg(what, grouped(static_cast<qulonglong>(hits))));
        Result<std::unique_ptr<Scene>> made = makeSessionScene(scene.load, options.pipeline, room.picture());
        if (!made) {
            return made.error();
        }
        RandomHits random(made.value()->hitTargets(), hitConstants(options.gentle), options.seed);
        std::vector<Hit> history = random.next(static_cast<std::size_t>(hits));
        if (figure.besideForm) {
            history.back().form.profile = DentProfile::Wendland;
        }
        made.value()->append(history);
        if (Status status = made.value()->draw(); !status) {
            return status.error();
        }
        scenes.push_back(std::move(made).value());
        Scene* still = scenes.back().get();
        variants.push_back({std::to_string(hits) + " hits", 1.0, {}, [still] { return still->draw(); }});
    }
    Result<std::vector<Samples>> samples = room.measure(what, variants, options.plan);
    if (!samples) {
        return samples.error();
    }
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto hits = static_cast<std::size_t>(figures[i].hits);
        figures[i].kept = hits - std::min(hits, scenes[i]->droppedHits());
        figures[i].frames = samples.value()[i];
    }
    return figures;
}

}  // namespace hitscope::bench
