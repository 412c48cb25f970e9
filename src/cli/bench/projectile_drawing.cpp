// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "cli/bench/physics_cost.h"
#include "gl/context.h"
#include "scene/scene_gpu.h"
#include "session/session.h"

namespace hitscope::bench {

namespace {

constexpr int kStepsToFullTrails = 40;

/// The scene the window opens with, standing still.
class FlightScene {
public:
    explicit FlightScene(const BenchRoom& room) : m_room(room) {}

    Status open(bool withProjectiles) {
        loadPaperRow(m_session, kDefaultPaperRow);
        m_session.settings().setPipeline(PipelineKind::TransformFeedback);
        if (withProjectiles) {
            launch();
        }
        Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(m_session);
        if (!gpu) {
            return gpu.error();
        }
        m_gpu = std::move(gpu).value();
        m_view.width = m_room.picture().width();
        m_view.height = m_room.picture().height();
        m_view.camera.frame(m_session.targets().bounds(),
                            static_cast<float>(m_view.width) / static_cast<float>(m_view.height));
        return m_gpu->sync();
    }

    Status draw() {
        Status status = m_gpu->draw(m_view, m_room.picture().framebuffer());
        gl::finish();
        return status;
    }

private:
    /// Straight up all over the scene, so that they strike nothing and do not hide each other.
    void launch() {
        ProjectileSettings settings;
        settings.mostAlive = kProjectiles;
        m_session.settings().setProjectile(settings);
        const Bounds bounds = m_session.targets().bounds();
        constexpr int kRow = 50;
        for (int i = 0; i < kProjectiles; ++i) {
            const int row = i / kRow;
            const glm::vec3 share(static_cast<float>(i % kRow) / kRow, 0.0f,
                                  static_cast<float>(row) * kRow / kProjectiles);
            glm::vec3 origin = bounds.min + share * bounds.size();
            origin.y = bounds.max.y + 1.0f;
            m_session.simulation().shoot({origin, {0.0f, 1.0f, 0.0f}});
        }
        m_session.simulation().advance(kStepsToFullTrails * StepClock::kStep);
    }

    const BenchRoom& m_room;
    Session m_session;
    std::unique_ptr<SceneGpu> m_gpu;
    SceneGpu::View m_view;
};

}  // namespace

Result<std::vector<Samples>> measureProjectileDrawing(const BenchRoom& room, const Plan& plan) {
    std::vector<std::unique_ptr<FlightScene>> scenes;
    std::vector<Variant> variants;
    for (const bool withProjectiles : {false, true}) {
        scenes.push_back(std::make_unique<FlightScene>(room));
        FlightScene* scene = scenes.back().get();
        if (Status status = scene->open(withProjectiles); !status) {
            return status.error();
        }
        variants.push_back(
            {withProjectiles ? "projectiles" : "none", 1.0, {}, [scene] { return scene->draw(); }});
    }
    return room.measure(QStringLiteral("drawing projectiles"), variants, plan);
}

}  // namespace hitscope::bench
