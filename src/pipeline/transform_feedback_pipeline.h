// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <vector>

#include "pipeline/capture_pass.h"
#include "pipeline/changed_ranges.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/target_reach.h"

namespace hitscope {

/// The paper's method 2 (section 2.2, Algorithm 2): a hit is applied once, to the vertices of the clusters it
/// reaches, and the result is copied over the dynamic buffer on the GPU. Nothing waits for the CPU but
/// readBack().
class TransformFeedbackPipeline final : public DeformationPipeline {
public:
    [[nodiscard]] static Result<std::unique_ptr<DeformationPipeline>> create();

    [[nodiscard]] const PipelineTraits& traits() const override;
    [[nodiscard]] std::optional<std::size_t> capacity() const override { return std::nullopt; }
    [[nodiscard]] std::size_t droppedHits() const override { return 0; }
    void addTarget(TargetId target, TargetBuffers& buffers) override;
    void removeTarget(TargetId target) override;
    void reset(std::span<const Hit> history) override;
    void append(std::span<const Hit> hits) override;
    void readBack(const ReadBackSink& sink) override;
    [[nodiscard]] gl::Defines drawDefines() const override { return {}; }
    void prepareDraw(const gl::Program& program, TargetId target) override;

private:
    struct TargetState {
        explicit TargetState(TargetBuffers& targetBuffers)
            : buffers(&targetBuffers), reach(targetBuffers.clusters()) {}
        TargetBuffers* buffers;
        TargetReach reach;
        ChangedRanges moved;   ///< since the original
        ChangedRanges unread;  ///< since the last readBack()
    };
    explicit TransformFeedbackPipeline(CapturePass pass);
    void apply(TargetState& target, std::span<const Hit* const> hits);
    [[nodiscard]] std::vector<VertexRange> applyBatch(TargetState& target, std::span<const Hit* const> hits);
    void flush(TargetState& target, std::vector<CaptureRun>& runs);

    CapturePass m_pass;
    HitArrays m_batch;
    std::unordered_map<TargetId, TargetState> m_targets;
};

}  // namespace hitscope
