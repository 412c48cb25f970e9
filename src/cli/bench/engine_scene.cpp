// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include "cli/bench/scene.h"
#include "cli/bench/texture.h"
#include "cli/bench_gl/paper_feedback.h"
#include "gl/context.h"

namespace hitscope::bench {

namespace {

Bounds worldBounds(const TargetPlan& plan) {
    const Bounds& local = plan.shape.render->bounds;
    Bounds world;
    for (int corner = 0; corner < 8; ++corner) {
        world.add(plan.transform.toWorld({(corner & 1) != 0 ? local.max.x : local.min.x,
                                          (corner & 2) != 0 ? local.max.y : local.min.y,
                                          (corner & 4) != 0 ? local.max.z : local.min.z}));
    }
    return world;
}

TargetId idOf(std::size_t index) {
    return TargetId{static_cast<std::uint32_t>(index + 1)};
}

class EngineScene final : public Scene {
public:
    EngineScene(const RowParts& parts, std::unique_ptr<DeformationPipeline> pipeline, Renderer& renderer,
                const gl::RenderTarget& picture)
        : m_parts(parts), m_renderer(renderer), m_picture(picture), m_pipeline(std::move(pipeline)) {
        addTargets();
        frameTargets();
    }

    /// From now on hits are applied as the paper does.
    Status useThePapersWay(const gl::Defines& deformDefines) {
        std::vector<PaperFeedback::Drawn> drawn;
        for (std::size_t i = 0; i < m_buffers.size(); ++i) {
            drawn.push_back({m_buffers[i].get(), m_parts.plans[i].shape.render->vertices});
        }
        Result<std::vector<PaperFeedback>> made = PaperFeedback::createOn(drawn, deformDefines);
        if (!made) {
            return made.error();
        }
        m_papers = std::move(made).value();
        return Done{};
    }

    void append(std::span<const Hit> hits) override {
        m_arrived.insert(m_arrived.end(), hits.begin(), hits.end());
    }

    Status draw() override {
        if (!m_arrived.empty()) {
            applyArrived();
            ++m_frame.meshRevision;
            m_arrived.clear();
        }
        m_pipeline->pollReadBack(
            [this](TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
                m_moved.clear();
                m_copies[target.value - 1].write(first, vertices, m_moved);
            });
        Status status = m_renderer.draw(m_frame, *m_pipeline, m_picture.framebuffer());
        gl::finish();
        return status;
    }

    std::vector<HitTarget> hitTargets() const override {
        std::vector<HitTarget> targets;
        for (std::size_t i = 0; i < m_parts.plans.size(); ++i) {
            targets.push_back({idOf(i), m_parts.plans[i].shape.render.get()});
        }
        return targets;
    }

    std::size_t droppedHits() const override { return m_pipeline->capacity().dropped.size(); }

private:
    void applyArrived() {
        if (m_papers.empty()) {
            m_pipeline->append(m_arrived);
            return;
        }
        for (const Hit& hit : m_arrived) {
            m_papers[hit.target.value - 1].apply(hit);
        }
    }

    void addTargets() {
        for (const TargetPlan& plan : m_parts.plans) {
            const TargetId id = idOf(m_buffers.size());
            m_buffers.push_back(std::make_unique<TargetBuffers>(*plan.shape.render));
            m_copies.emplace_back(plan.shape.mesh, plan.shape.render);
            m_pipeline->addTarget(id, *m_buffers.back());
            m_items.push_back(
                {id, m_buffers.back().get(), m_parts.materials.get(), plan.transform.matrix(), false});
        }
    }

    void frameTargets() {
        Bounds bounds;
        for (const TargetPlan& plan : m_parts.plans) {
            bounds.add(worldBounds(plan));
        }
        const glm::vec3 size = bounds.size();
        m_frame.width = m_picture.width();
        m_frame.height = m_picture.height();
        m_frame.camera.frame(bounds, static_cast<float>(m_frame.width) / static_cast<float>(m_frame.height));
        m_frame.lights = defaultLights({bounds.centre(), std::max({size.x, size.y, size.z})});
        m_frame.options = m_parts.options;
        m_frame.meshRevision = 1;
        m_frame.floorHeight = bounds.min.y;
        m_frame.targets = m_items;
    }

    const RowParts& m_parts;
    Renderer& m_renderer;
    const gl::RenderTarget& m_picture;
    std::vector<std::unique_ptr<TargetBuffers>> m_buffers;
    std::unique_ptr<DeformationPipeline> m_pipeline;  // below the buffers it is given, so that it goes first
    std::vector<PaperFeedback> m_papers;              // empty, or one a target
    std::vector<DeformedMesh> m_copies;
    std::vector<std::uint32_t> m_moved;
    std::vector<DrawItem> m_items;
    std::vector<Hit> m_arrived;
    Frame m_frame;
};

}  // namespace

std::vector<TargetPlan> planRow(const PaperRow& row, bool textured) {
    std::vector<TargetPlan> plans = planPaperRow(row);
    if (!textured) {
        return plans;
    }
    std::map<const MeshData*, PreparedMesh> shapes;
    for (TargetPlan& plan : plans) {
        PreparedMesh& shape = shapes[plan.shape.mesh.get()];
        if (!shape.mesh) {
            MeshData mesh = *plan.shape.mesh;
            useTexture(mesh);
            shape = prepareMesh(std::move(mesh));
        }
        plan.shape = shape;
    }
    return plans;
}

Result<std::unique_ptr<Scene>> makeEngineScene(const RowParts& parts,
                                               std::unique_ptr<DeformationPipeline> pipeline,
                                               Renderer& renderer, const gl::RenderTarget& picture, HitsBy by,
                                               const gl::Defines& deformDefines) {
    auto scene = std::make_unique<EngineScene>(parts, std::move(pipeline), renderer, picture);
    if (by == HitsBy::Paper) {
        if (Status used = scene->useThePapersWay(deformDefines); !used) {
            return used.error();
        }
    }
    return std::unique_ptr<Scene>(std::move(scene));
}

}  // namespace hitscope::bench
