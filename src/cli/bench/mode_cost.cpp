// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/mode_cost.h"

#include <vector>

#include "cli/bench/paper_figures.h"
#include "cli/bench/scene.h"

namespace hitscope::bench {

namespace {

constexpr std::size_t kRow = 6;
constexpr std::uint32_t kSeed = 1;
constexpr std::size_t kHits = 600;

}  // namespace

Result<double> modeCost(const BenchRoom& room, const Plan& plan, DisplayOptions options) {
    options.normals = NormalMode::Paper;
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create();
    if (!renderer) {
        return renderer.error();
    }
    const DisplayOptions looks[] = {DisplayOptions{.normals = NormalMode::Paper}, options};
    std::vector<RowParts> parts;
    std::vector<std::unique_ptr<Scene>> scenes;
    std::vector<Variant> variants;
    parts.reserve(std::size(looks));
    for (const DisplayOptions& look : looks) {
        Result<std::unique_ptr<DeformationPipeline>> pipeline =
            room.makePipeline(PipelineKind::TransformFeedback);
        if (!pipeline) {
            return pipeline.error();
        }
        parts.push_back({planRow(paperRows()[kRow], false), nullptr, look});
        scenes.push_back(
            makeEngineScene(parts.back(), std::move(pipeline).value(), *renderer.value(), room.picture()));
        Scene* scene = scenes.back().get();
        scene->append(RandomHits(scene->hitTargets(), DeformationConstants(), kSeed).next(kHits));
        variants.push_back({"mode", 1.0, {}, [scene] { return scene->draw(); }});
    }
    Result<std::vector<Samples>> samples = room.measure(QStringLiteral("modes"), variants, plan);
    if (!samples) {
        return samples.error();
    }
    return timeRatio(samples.value()[1], samples.value()[0]);
}

}  // namespace hitscope::bench
