// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/cost_measurement.h"

#include <QElapsedTimer>
#include <QThread>
#include <random>
#include <utility>

#include "gl/context.h"
#include "gl/render_target.h"
#include "session/scene_gpu.h"

namespace hitscope {

struct CostMeasurement::Order {
    ScenePlan scene;
    DeformationConstants constants;
    Lights lights;
    Camera camera;
    CostPlan plan;
};

struct CostMeasurement::Sample {
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    std::size_t hits = 0;
    double frame = 0.0;  ///< seconds
    double hit = 0.0;    ///< seconds
};

namespace {

/// Head-on, at the vertices of the session's targets in turn.
std::vector<Hit> drawHits(const Session& session, std::size_t count) {
    std::vector<Hit> hits;
    std::mt19937 random(1);
    while (hits.size() < count) {
        const Target& target = *session.targets()[hits.size() % session.targets().size()];
        const std::span<const DynamicVertex> vertices = target.deformed.vertices();
        const DynamicVertex& vertex = vertices[random() % vertices.size()];
        Hit hit;
        hit.target = target.id;
        hit.point = vertex.position;
        hit.direction = -vertex.normal;
        hit.constants = session.constants();
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
        made->m_session.setPipeline(pipeline);
        made->m_session.restoreLights(lights);
        if (Status status = made->m_session.restoreConstants({constants}); !status) {
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

    [[nodiscard]] PipelineKind pipeline() const { return m_session.pipeline(); }
    Status grow(std::size_t hits) {
        const std::size_t has = m_session.history().size();
        if (hits <= has) {
            return Done{};
        }
        const Status status = m_session.addHits(std::span(m_hits).subspan(has, hits - has));
        return status ? m_gpu->sync() : status;
    }
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
        if (Status status = m_session.addHit(m_hits[sample % m_hits.size()]); !status) {
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

private:
    Subject() = default;
    Session m_session;
    std::vector<Hit> m_hits;
    std::unique_ptr<SceneGpu> m_gpu;
};

Result<std::vector<std::unique_ptr<Subject>>> makeSubjects(const ScenePlan& scene, const CostPlan& plan,
                                                           const DeformationConstants& constants,
                                                           const Lights& lights) {
    std::vector<std::unique_ptr<Subject>> subjects;
    for (const PipelineKind pipeline : plan.pipelines) {
        Result<std::unique_ptr<Subject>> made =
            Subject::make(scene, pipeline, constants, lights, std::max<std::size_t>(plan.hits.back(), 1));
        if (!made) {
            return made.error();
        }
        subjects.push_back(std::move(made).value());
    }
    return subjects;
}

ScenePlan planOf(const Session& session) {
    ScenePlan plan;
    plan.floorHeight = session.floorHeight();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (target->visible && !target->deformed.vertices().empty()) {
            plan.targets.push_back({target->name, target->shape, target->transform, *target->collider, {}});
        }
    }
    return plan;
}

}  // namespace

CostMeasurement::CostMeasurement(QObject* parent) : QObject(parent) {}

CostMeasurement::~CostMeasurement() {
    if (m_thread != nullptr) {
        m_cancelled->store(true);
        m_thread->wait();
        delete m_thread;
    }
}

Status CostMeasurement::measure(const Order& order, const std::atomic<bool>& cancelled,
                                const std::function<void(const Sample&, int, int)>& report) {
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
                if (Status status = subject->grow(hits); !status) {
                    return status;
                }
                const Result<double> hit = subject->hit(hits + static_cast<std::size_t>(round + 1));
                const Result<double> frame = subject->frame(view, picture);
                if (!hit || !frame) {
                    return hit ? frame.error() : hit.error();
                }
                if (round >= 0) {
                    report({subject->pipeline(), hits, frame.value(), hit.value()}, done, total);
                }
            }
            done += round >= 0 ? 1 : 0;
        }
    }
    return Done{};
}

void CostMeasurement::start(const Session& session, const Camera& camera, CostPlan plan) {
    if (m_thread != nullptr) {
        cancel();
        end();
    }
    m_curves.clear();
    m_cancelled = std::make_shared<std::atomic<bool>>(false);
    auto order = std::make_shared<const Order>(
        Order{planOf(session), session.constants(), session.lights(), camera, std::move(plan)});
    // What arrives from a measurement that was cancelled is not of this one.
    const auto whenCurrent = [this, mine = m_cancelled](auto act) {
        QMetaObject::invokeMethod(this, [this, mine, act] {
            if (mine == m_cancelled) {
                act();
            }
        });
    };
    m_thread = QThread::create([this, order, whenCurrent, cancelled = m_cancelled] {
        const Status status = measure(*order, *cancelled, [&](const Sample& sample, int done, int total) {
            whenCurrent([this, sample, done, total] {
                m_curves.addFrame(sample.pipeline, sample.hits, sample.frame);
                m_curves.addHit(sample.pipeline, sample.hits, sample.hit);
                Q_EMIT progressed(done + 1, total);
            });
        });
        whenCurrent([this, status] {
            end();
            if (!status) {
                Q_EMIT failed(QString::fromStdString(status.error().message()));
            }
            Q_EMIT finished();
        });
    });
    m_thread->start(QThread::LowPriority);
}

void CostMeasurement::cancel() {
    if (m_cancelled) {
        m_cancelled->store(true);
    }
}

void CostMeasurement::end() {
    m_thread->wait();
    m_thread->deleteLater();
    m_thread = nullptr;
}

}  // namespace hitscope
