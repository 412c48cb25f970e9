// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <unordered_map>
#include <vector>

#include "pipeline/capture_pass.h"
#include "pipeline/changed_ranges.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/hit_arrays.h"
#include "pipeline/target_reach.h"

namespace hitscope {

/// The paper's method 1 (section 2.1, Algorithm 1): the last hits of the scene stand in uniform arrays, and
/// whoever draws a target applies them to its original vertices, every frame. The dynamic buffer is never
/// written.
class UniformArrayPipeline final : public DeformationPipeline {
public:
    [[nodiscard]] static Result<std::unique_ptr<DeformationPipeline>> create(const PipelineLimits& limits);

    [[nodiscard]] const PipelineTraits& traits() const override;
    [[nodiscard]] std::optional<std::size_t> capacity() const override { return m_capacity; }
    [[nodiscard]] std::size_t droppedHits() const override { return m_dropped; }
    void addTarget(TargetId target, TargetBuffers& buffers) override;
    void removeTarget(TargetId target) override;
    void reset(std::span<const Hit> history) override;
    void append(std::span<const Hit> hits) override;
    /// Captures what the drawing programs compute, with the same code over the same vertices.
    void readBack(const ReadBackSink& sink) override;
    [[nodiscard]] gl::Defines drawDefines() const override { return hitArrayDefines(m_capacity); }
    void prepareDraw(const gl::Program& program, TargetId target) override;

private:
    struct TargetState {
        explicit TargetState(TargetBuffers& targetBuffers)
            : buffers(&targetBuffers), reach(targetBuffers.clusters()) {}
        TargetBuffers* buffers;
        TargetReach reach;
        ChangedRanges moved;       ///< since the original
        ChangedRanges unread;      ///< since the last readBack()
        std::size_t firstHit = 0;  ///< the target's hits in the arrays: [firstHit, lastHit)
        std::size_t lastHit = 0;
    };
    UniformArrayPipeline(CapturePass pass, std::size_t capacity);
    [[nodiscard]] std::size_t hitsToKeep() const;
    void dropOldest();
    void fillArrays();

    CapturePass m_pass;
    std::size_t m_capacity;
    std::unordered_map<TargetId, TargetState> m_targets;
    std::deque<Hit> m_hits;  ///< of the scene, oldest first
    std::size_t m_dropped = 0;
    HitArrays m_arrays;         ///< m_hits, each target's together
    std::uint64_t m_stamp = 0;  ///< names what is in m_arrays, among all pipelines there ever were
    bool m_captureIsCurrent = false;
};

}  // namespace hitscope
