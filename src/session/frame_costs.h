// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/ring.h"
#include "deform/pipeline_kind.h"

namespace hitscope {

class HitRows;
class Session;

/// What one frame cost. Seconds; the parts of the CPU's time are the drawing thread's.
struct FrameCost {
    std::uint64_t number = 0;
    double end = 0.0;     ///< when it ended, by FrameCosts::now()
    double total = 0.0;   ///< from the end of the frame before while frames follow each other, else `cpu`
    bool follows = true;  ///< the frame before: else the GPU may have needed longer than `total`
    double cpu = 0.0;     ///< the sum of the parts
    // Parts
    double physics = 0.0;      ///< steps since the frame before
    double deformation = 0.0;  ///< handing changed hits to the pipeline
    double readBack = 0.0;     ///< taking what came back from the GPU, normals around it
    double drawing = 0.0;      ///< everything else
    // The GPU's; nothing: not known, or not yet
    std::optional<double> gpu = {};
    std::optional<double> gpuDeformation = {};  ///< in `gpu`

    std::uint32_t hits = 0;     ///< that arrived in it
    std::uint32_t history = 0;  ///< hits in the history
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    std::uint8_t pipelines = 1;  ///< kept up, and drawn side by side: 2 while they are compared
};

/// What applying a hit cost, seconds: its share of the hits that were applied together with it.
struct HitCost {
    double cpu = 0.0;
    std::optional<double> gpu = {};  ///< nothing: not known, or not yet
    std::size_t together = 1;        ///< so many were applied at once
    PipelineKind pipeline = PipelineKind::TransformFeedback;

    bool operator==(const HitCost&) const = default;
};

/// What the frames of a session cost, and each of its hits when it was applied. SceneGpu and the session
/// report here; everyone else reads. The GPU's times come some frames late.
class FrameCosts : public QObject {
    Q_OBJECT
public:
    /// Made by the session, which outlives it.
    explicit FrameCosts(const Session& session);

    static constexpr std::size_t kMostFrames = 8192;
    /// The last kMostFrames.
    [[nodiscard]] const Ring<FrameCost>& frames() const { return m_frames; }
    /// Nothing for a hit that no frame has applied yet, or only as part of a change of earlier hits.
    /// index < the history's size.
    [[nodiscard]] std::optional<HitCost> hitCost(std::size_t index) const;
    /// Whether the driver can measure the GPU's time; nothing: it is not known yet.
    [[nodiscard]] std::optional<bool> measuresGpu() const { return m_measuresGpu; }
    [[nodiscard]] double now() const;  ///< seconds since the session was made

    // What is reported
    void setMeasuresGpu(bool measures) { m_measuresGpu = measures; }
    void addPhysics(double seconds) { m_work.physics += seconds; }
    /// The number that the next frame will have.
    [[nodiscard]] std::uint64_t nextFrame() const { return m_nextFrame; }
    /// A frame was drawn: number, end, total, cpu, physics, history and pipeline are filled in here.
    void addFrame(FrameCost cost);
    /// The last frame took so long in all. `follows`: since the end of the frame before; else it stands
    /// alone, and what the GPU still had to do is not in it.
    void endFrame(double total, bool follows = true);
    /// The hits [first, first + count) were applied with the work numbered `frame`: seconds of CPU time.
    void addApplied(std::uint64_t frame, std::size_t first, std::size_t count, double cpu);
    /// What the GPU says of the work numbered `frame`, seconds. It belongs to that frame or the one after.
    void addGpuTimes(std::uint64_t frame, double all, double deformation);
    /// Work on the way to the next frame, such as hits applied between two steps of the physics: it has a
    /// number of its own, and its deformation, read-back and hits are part of the next frame's.
    void addWork(const FrameCost& cost);

Q_SIGNALS:
    void frameEnded();
    void hitCostsChanged(int first, int last);  ///< of these hits, and perhaps not of all of them

private:
    void clear();
    void followRows(const HitRows& rows);

    /// Hits that were applied together.
    struct Batch {
        std::uint64_t frame = 0;
        std::size_t hits = 0;
        double cpu = 0.0;  ///< seconds, all together
        std::optional<double> gpu = {};
        PipelineKind pipeline = PipelineKind::TransformFeedback;
    };
    static constexpr std::uint32_t kNoBatch = 0xffffffffU;

    const Session& m_session;
    QElapsedTimer m_clock;
    Ring<FrameCost> m_frames{kMostFrames};
    std::uint64_t m_nextFrame = 1;
    FrameCost m_work;  ///< since the last frame: physics, deformation, readBack, hits
    std::optional<bool> m_measuresGpu;
    std::vector<Batch> m_batches;          ///< by frame, ascending
    std::vector<std::uint32_t> m_batchOf;  ///< by hit; may be shorter than the history
};

}  // namespace hitscope
