// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/capture_pass.h"
#include "pipeline/kept_vertices_pipeline.h"
#include "pipeline/stream_texture.h"

namespace hitscope {

/// The paper's method 2 (section 2.2, Algorithm 2): hits are applied in a vertex shader, to the vertices of
/// the clusters they reach; transform feedback captures these, and they are copied over the dynamic buffer on
/// the GPU.
class TransformFeedbackPipeline final : public KeptVerticesPipeline {
public:
    [[nodiscard]] static Result<std::unique_ptr<DeformationPipeline>> create(const PipelineOptions& options);
    [[nodiscard]] const PipelineTraits& traits() const override;

private:
    TransformFeedbackPipeline(CapturePass pass, CapturePass forms, bool startsLate);
    void deform(TargetId target, TargetBuffers& buffers, const HitBatch& batch) override;
    void learnTarget(TargetId target, TargetBuffers& buffers) override;
    void deformPart(CapturePass& pass, TargetBuffers& buffers, std::span<const ClusterHits> clusters,
                    std::size_t firstHit, std::size_t firstIndex);
    void prepare(const gl::Program& program, std::size_t firstHit, std::size_t firstIndex) const;

    CapturePass m_pass;   ///< for the paper's function alone
    CapturePass m_forms;  ///< for all forms
    StreamTexture m_hits;
    StreamTexture m_indices;
    StreamTexture m_clusters;
    std::vector<CaptureRun> m_runs;
};

}  // namespace hitscope
