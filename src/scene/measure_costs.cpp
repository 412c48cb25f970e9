// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measure_costs.h"

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "gl/context.h"
#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "pipeline/deformation_pipeline.h"
#include "scene/scene_gpu.h"

namespace hitscope {

namespace {

/// Head-on, at the vertices of the session's targets in turn.
std::vector<Hit> drawHits(const Session& session, std::size_t count) {
    std::vector<Hit> hits;
    std::mt19937 random(1);
    while (hits.size() < count) {
        const Target& target = *session.targets()[hits.size() % session.targets().size()];
        const auto vertices = target.deformed.vertices().first(target.deformed.render().drawnVertices);
        const DynamicVertex& vertex = vertices[random() % vertices.size()];
        Hit hit;
        hit.target = target.id;
        hit.point = vertex.position;
        hit.direction = -vertex.normal;
        hit.constants = session.settings().constants();
        hits.push_back(hit);
    }
    return hits;
}

/// One pipeline's scene.
class Subject {
public:
    [[nodiscard]] static Result<std::unique_ptr<Subject>> make(const ScenePlan& scene, PipelineKind pipeline,
                                                               const DeformationConstants& constants,
                                                               const Lights& lights, std::size_t mostHits) {
        std::unique_ptr<Subject> made(new Subject);
        made->m_session.loadScene(scene);
        made->m_session.settings().setPipeline(pipeline);
        made->m_session.settings().restoreLights(lights);
        if (Status status = made->m_session.settings().restoreConstants({constants}); !status) {
            return status.error();
        }
        made->m_hits = drawHits(made->m_session, mostHits);
        Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(made->m_session);
        if (!gpu) {
            return gpu.error();
        }
        made->m_gpu = std::move(gpu).value();
        return made;
    }

    [[nodiscard]] PipelineKind pipeline() const { return m_session.settings().pipeline(); }
    /// Seconds until the picture is there.
    Result<double> frame(const SceneGpu::View& view, const gl::RenderTarget& picture) {
        QElapsedTimer clock;
        clock.start();
        if (Status status = m_gpu->draw(view, picture.framebuffer()); !status) {
            return status.error();
        }
        gl::finish();
        return static_cast<double>(clock.nsecsElapsed()) * 1.0e-9;
    }
    /// Seconds until one more hit is applied, read back, and the normals around it are known.
    Result<double> hit(std::size_t sample) {
        QElapsedTimer clock;
        clock.start();
        if (Status status = m_session.hits().add(m_hits[sample % m_hits.size()]); !status) {
            return status.error();
        }
        if (Status status = m_gpu->sync(); !status) {
            return status.error();
        }
        gl::finish();
        const double seconds = static_cast<double>(clock.nsecsElapsed()) * 1.0e-9;
        m_session.undo();
        const Status status = m_gpu->sync();
        return status ? Result<double>(seconds) : Result<double>(status.error());
    }

    struct Times {
        double frame = 0.0;  ///< seconds
        double hit = 0.0;    ///< seconds
    };
    /// With so many hits in the history, and one more.
    Result<Times> sample(std::size_t hits, std::size_t number, const SceneGpu::View& view,
                         const gl::RenderTarget& picture) {
        if (Status status = grow(hits); !status) {
            return status.error();
        }
        const Result<double> one = hit(hits + number);
        const Result<double> whole = frame(view, picture);
        if (!one || !whole) {
            return one ? whole.error() : one.error();
        }
        return Times{whole.value(), one.value()};
    }

private:
    Subject() = default;
    Status grow(std::size_t hits) {
        const std::size_t has = m_session.hits().history().size();
        if (hits <= has) {
            return Done{};
        }
        const Status status = m_session.hits().add(std::span(m_hits).subspan(has, hits - has));
        return status ? m_gpu->sync() : status;
    }
    Session m_session;
    std::vector<Hit> m_hits;
    std::unique_ptr<SceneGpu> m_gpu;
};

/// Those that run here, which only a context tells.
std::vector<PipelineKind> runnable(std::vector<PipelineKind> pipelines) {
    std::erase_if(pipelines, [](PipelineKind kind) { return whyUnavailable(kind).has_value(); });
    return pipelines;
}

Result<std::vector<std::unique_ptr<Subject>>> makeSubjects(const ScenePlan& scene, const CostPlan& plan,
                                                           const DeformationConstants& constants,
                                                           const Lights& lights) {
    std::vector<std::unique_ptr<Subject>> subjects;
    for (const PipelineKind pipeline : runnable(plan.pipelines)) {
        Result<std::unique_ptr<Subject>> made =
            Subject::make(scene, pipeline, constants, lights, std::max<std::size_t>(plan.hits.back(), 1));
        if (!made) {
            return made.error();
        }
        subjects.push_back(std::move(made).value());
    }
    return subjects;
}

/// About so many vertices, twice as many columns as rows.
ScenePlan sphereOf(std::size_t vertices) {
    constexpr float kRadius = 2.5f;  // metres
    constexpr int kFewestRings = 8;
    const int rings =
        std::max(static_cast<int>(std::lround(std::sqrt(0.5 * static_cast<double>(vertices)))), kFewestRings);
    ScenePlan plan;
    plan.targets.push_back(planMesh(makeUvSphere(2 * rings, rings, kRadius)));
    return plan;
}

Status measureScene(const CostOrder& order, const std::atomic<bool>& cancelled,
                    const CostMeter::Report& report) {
    if (order.scene.targets.empty()) {
        return Error{"There is nothing to measure.", "", "Show a target with a surface."};
    }
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    const gl::RenderTarget picture(order.plan.width, order.plan.height);
    auto subjects = makeSubjects(order.scene, order.plan, order.constants, order.lights);
    if (!subjects) {
        return subjects.error();
    }
    SceneGpu::View view;
    view.width = order.plan.width;
    view.height = order.plan.height;
    view.camera = order.camera;
    const int total = static_cast<int>(order.plan.hits.size()) * order.plan.samples;
    int done = 0;
    for (const std::size_t hits : order.plan.hits) {
        for (int round = -1; round < order.plan.samples; ++round) {  // the first warms up
            for (const std::unique_ptr<Subject>& subject : subjects.value()) {
                if (cancelled) {
                    return Done{};
                }
                const Result<Subject::Times> times =
                    subject->sample(hits, static_cast<std::size_t>(round + 1), view, picture);
                if (!times) {
                    return times.error();
                }
                if (round >= 0) {
                    report({subject->pipeline(), hits, times.value().frame, times.value().hit}, done, total);
                }
            }
            done += round >= 0 ? 1 : 0;
        }
    }
    return Done{};
}

/// One pipeline after the other, so that only one has its copies of a million vertices.
Status measureSizes(const SizePlan& plan, const std::atomic<bool>& cancelled,
                    const CostMeter::Report& report) {
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    const gl::RenderTarget picture(plan.width, plan.height);
    SceneGpu::View view;
    view.width = plan.width;
    view.height = plan.height;
    const std::vector<PipelineKind> pipelines = runnable(plan.pipelines);
    const int total = static_cast<int>(plan.vertices.size() * pipelines.size()) * plan.samples;
    int done = 0;
    for (const std::size_t vertices : plan.vertices) {
        const ScenePlan scene = sphereOf(vertices);
        const RenderMesh& mesh = *scene.targets.front().shape.render;
        view.camera.frame(worldBounds(mesh, scene.targets.front().transform),
                          static_cast<float>(plan.width) / static_cast<float>(plan.height));
        for (const PipelineKind pipeline : pipelines) {
            Result<std::unique_ptr<Subject>> subject =
                Subject::make(scene, pipeline, DeformationConstants{}, defaultLights({}), plan.hits);
            if (!subject) {
                return subject.error();
            }
            for (int round = -1; round < plan.samples; ++round) {  // the first warms up
                if (cancelled) {
                    return Done{};
                }
                const Result<Subject::Times> times =
                    subject.value()->sample(plan.hits, static_cast<std::size_t>(round + 1), view, picture);
                if (!times) {
                    return times.error();
                }
                if (round >= 0) {
                    report({pipeline, mesh.vertices.size(), times.value().frame, times.value().hit}, done++,
                           total);
                }
            }
        }
    }
    return Done{};
}

}  // namespace

CostMeter costMeter() {
    return {measureScene, measureSizes};
}

}  // namespace hitscope
