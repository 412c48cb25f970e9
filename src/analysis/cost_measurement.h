// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "analysis/cost_curves.h"
#include "core/result.h"
#include "session/session.h"
#include "view/camera.h"

class QThread;

namespace hitscope {

/// What a measurement measures, and how thoroughly.
struct CostPlan {
    int width = 960;   ///< pixels
    int height = 540;  ///< pixels
    std::vector<PipelineKind> pipelines = pipelinesPapersFirst();
    std::vector<std::size_t> hits = {0, 25, 50, 100, 150, 200, 300, 400, 500, 600};  ///< ascending
    int samples = 5;  ///< of a frame and of a hit, each
};

/// What a measurement against the number of vertices measures: a sphere 5 m across, as the paper's, with the
/// paper's constants.
struct SizePlan {
    int width = 960;   ///< pixels
    int height = 540;  ///< pixels
    std::vector<PipelineKind> pipelines = CostPlan{}.pipelines;
    std::vector<std::size_t> vertices = {1'000, 4'000, 16'000, 64'000, 250'000, 1'000'000};  ///< about
    std::size_t hits = 100;  ///< in the history, spread over the sphere
    int samples = 3;         ///< of a frame and of a hit, each
};

/// What is measured of a session's scene: its visible targets, whole.
struct CostOrder {
    ScenePlan scene;
    DeformationConstants constants;
    Lights lights;
    Camera camera;
    CostPlan plan;
};

struct CostSample {
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    std::size_t at = 0;  ///< hits in the history, or vertices
    double frame = 0.0;  ///< seconds
    double hit = 0.0;    ///< seconds
};

/// What takes the samples, on the measurement's thread: costMeter() of scene/measure_costs.h, where there is
/// OpenGL.
struct CostMeter {
    using Report = std::function<void(const CostSample&, int done, int total)>;
    std::function<Status(const CostOrder&, const std::atomic<bool>& cancelled, const Report&)> scene;
    std::function<Status(const SizePlan&, const std::atomic<bool>& cancelled, const Report&)> sizes;
};

/// Measures frames and hits of a session's scene, or of spheres of many sizes, by themselves, on a thread of
/// its own.
class CostMeasurement : public QObject {
    Q_OBJECT
public:
    explicit CostMeasurement(CostMeter meter, QObject* parent = nullptr);
    ~CostMeasurement() override;  ///< cancels, and waits for the sample being taken

    /// The visible targets, whole, and the session's constants; hits at vertices drawn by lot, always the
    /// same. One that runs is cancelled.
    void start(const Session& session, const Camera& camera, CostPlan plan = {});
    /// Spheres of more and more vertices; curves() are against their number.
    void start(SizePlan plan);
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_thread != nullptr; }
    /// So far, of the last one started.
    [[nodiscard]] const CostCurves& curves() const { return m_curves; }

Q_SIGNALS:
    void progressed(int done, int total);  ///< curves() has grown
    void finished();                       ///< cancelled, or complete
    void failed(const QString& why);       ///< and so is finished

private:
    using Measure =
        std::function<Status(const std::atomic<bool>& cancelled, const CostMeter::Report& report)>;
    void run(Measure measure);
    void end();

    CostMeter m_meter;
    CostCurves m_curves;
    QThread* m_thread = nullptr;
    std::shared_ptr<std::atomic<bool>> m_cancelled;
};

}  // namespace hitscope
