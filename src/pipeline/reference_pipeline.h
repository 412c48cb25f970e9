// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <vector>

#include "pipeline/kept_vertices_pipeline.h"

namespace hitscope {

/// Hits are applied in C++, by the deformation function that the others are held against, to the clusters
/// they reach; these are uploaded.
class ReferencePipeline final : public KeptVerticesPipeline {
public:
    [[nodiscard]] const PipelineTraits& traits() const override;

private:
    void deform(TargetId target, TargetBuffers& buffers, const HitBatch& batch) override;
    void learnTarget(TargetId target, TargetBuffers& buffers) override;
    void forgetTarget(TargetId target) override;
    void followWrites(TargetId target, const TargetBuffers& buffers,
                      std::span<const VertexRange> ranges) override;

    std::unordered_map<TargetId, std::vector<DynamicVertex>> m_vertices;  ///< as in the dynamic buffers
};

}  // namespace hitscope
