// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/program.h"
#include "pipeline/kept_vertices_pipeline.h"
#include "pipeline/stream_buffer.h"

namespace hitscope {

/// Hits are applied in a compute shader, a work group for each cluster they reach, to the vertices where they
/// lie.
class ComputePipeline final : public KeptVerticesPipeline {
public:
    /// The context has compute shaders (GL 4.3).
    [[nodiscard]] static Result<std::unique_ptr<DeformationPipeline>> create(const PipelineOptions& options);
    [[nodiscard]] const PipelineTraits& traits() const override;

private:
    ComputePipeline(gl::Program program, gl::Program forms);
    void deform(TargetId target, TargetBuffers& buffers, const HitBatch& batch) override;
    void dispatchAll(const gl::Program& program, const TargetBuffers& buffers,
                     std::span<const ClusterHits> clusters);
    void dispatch(const gl::Program& program, const TargetBuffers& buffers,
                  std::span<const ClusterHits> clusters);

    gl::Program m_program;  ///< for the paper's function alone
    gl::Program m_forms;    ///< for all forms
    StreamBuffer m_hits;
    StreamBuffer m_indices;
    StreamBuffer m_clusters;
    std::size_t m_bindableVertices;  ///< of a dynamic buffer at once
};

}  // namespace hitscope
