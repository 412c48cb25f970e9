// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/arrival.h"

#include <memory>
#include <utility>

#include "cli/bench/random_hits.h"
#include "gl/context.h"
#include "scene/scene_gpu.h"
#include "session/session.h"

namespace hitscope::bench {

namespace {

/// A session on the GPU that takes some hits at once.
struct Arrival {
    Session session;
    std::unique_ptr<SceneGpu> gpu;
    std::optional<RandomHits> random;
    std::size_t hitsAtOnce = 0;
    std::vector<Hit> hits;
    const gl::RenderTarget* picture = nullptr;
    SceneGpu::View view;

    Status settle() {
        Status status = gpu->sync();
        gl::finish();
        return status;
    }

    /// Hits arrive between frames: a picture is drawn before them, and what it leaves in the caches is what
    /// they meet.
    Status prepare() {
        session.hits().clear();
        hits = random->next(hitsAtOnce);
        if (Status status = settle(); !status) {
            return status;
        }
        Status status = gpu->draw(view, picture->framebuffer());
        gl::finish();
        return status;
    }

    Status arrive() {
        if (Status status = session.hits().add(hits); !status) {
            return status;
        }
        return settle();
    }
};

Result<std::unique_ptr<Arrival>> makeArrival(const BenchRoom& room, const StillScene& scene,
                                             PipelineKind pipeline, int hitsAtOnce, std::uint32_t seed) {
    auto arrival = std::make_unique<Arrival>();
    arrival->picture = &room.picture();
    arrival->view.width = room.picture().width();
    arrival->view.height = room.picture().height();
    scene.load(arrival->session);
    arrival->session.settings().setPipeline(pipeline);
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(arrival->session);
    if (!gpu) {
        return gpu.error();
    }
    arrival->gpu = std::move(gpu).value();
    arrival->view.camera.frame(
        arrival->session.targets().bounds(),
        static_cast<float>(arrival->view.width) / static_cast<float>(arrival->view.height));
    std::vector<HitTarget> targets;
    for (const std::unique_ptr<Target>& target : arrival->session.targets()) {
        targets.push_back({target->id, &target->deformed.render()});
    }
    arrival->random.emplace(targets, DeformationConstants{}, seed);
    arrival->hitsAtOnce = static_cast<std::size_t>(hitsAtOnce);
    return arrival;
}

}  // namespace

Result<std::vector<Samples>> measureArrivals(const BenchRoom& room, const StillScene& scene,
                                             PipelineKind pipeline, const std::vector<int>& hitsAtOnce,
                                             std::uint32_t seed, const Plan& plan) {
    std::vector<std::unique_ptr<Arrival>> arrivals;
    std::vector<Variant> variants;
    for (const int hits : hitsAtOnce) {
        Result<std::unique_ptr<Arrival>> made = makeArrival(room, scene, pipeline, hits, seed);
        if (!made) {
            return made.error();
        }
        arrivals.push_back(std::move(made).value());
        Arrival* arrival = arrivals.back().get();
        variants.push_back({std::to_string(hits) + " hits", 1.0, [arrival] { return arrival->prepare(); },
                            [arrival] { return arrival->arrive(); }});
    }
    return room.measure(QStringLiteral("arriving hits"), variants, plan);
}

}  // namespace hitscope::bench
