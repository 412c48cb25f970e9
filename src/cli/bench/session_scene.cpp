// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "cli/bench/scene.h"
#include "gl/context.h"
#include "scene/scene_gpu.h"

namespace hitscope::bench {

namespace {

class SessionScene final : public Scene {
public:
    explicit SessionScene(const gl::RenderTarget& picture) : m_picture(picture) {}

    Status open(const std::function<void(Session&)>& load, PipelineKind pipeline) {
        load(m_session);
        m_session.settings().setPipeline(pipeline);
        m_session.targets().select({});
        Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(m_session);
        if (!gpu) {
            return gpu.error();
        }
        m_gpu = std::move(gpu).value();
        m_view.width = m_picture.width();
        m_view.height = m_picture.height();
        m_view.options.normals = NormalMode::Paper;
        m_view.camera.frame(m_session.targets().bounds(),
                            static_cast<float>(m_view.width) / static_cast<float>(m_view.height));
        return m_gpu->sync();
    }

    void append(std::span<const Hit> hits) override {
        static_cast<void>(m_session.hits().add(hits));  // made on the session's own targets
        m_session.targets().select({});                 // a selected target is drawn with an outline
    }

    Status draw() override {
        Status status = m_gpu->draw(m_view, m_picture.framebuffer());
        gl::finish();
        return status;
    }

    std::vector<HitTarget> hitTargets() const override {
        std::vector<HitTarget> targets;
        for (const std::unique_ptr<Target>& target : m_session.targets()) {
            targets.push_back({target->id, &target->deformed.render()});
        }
        return targets;
    }

    std::size_t droppedHits() const override { return m_session.readBack().droppedHits(); }

private:
    const gl::RenderTarget& m_picture;
    Session m_session;
    std::unique_ptr<SceneGpu> m_gpu;
    SceneGpu::View m_view;
};

}  // namespace

Result<std::unique_ptr<Scene>> makeSessionScene(const std::function<void(Session&)>& load,
                                                PipelineKind pipeline, const gl::RenderTarget& picture) {
    auto scene = std::make_unique<SessionScene>(picture);
    if (Status status = scene->open(load, pipeline); !status) {
        return status.error();
    }
    return std::unique_ptr<Scene>(std::move(scene));
}

}  // namespace hitscope::bench
