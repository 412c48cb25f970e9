// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/reference_pipeline.h"

#include "deform/deform_all.h"

namespace hitscope {

const PipelineTraits& ReferencePipeline::traits() const {
    return pipelineTraits(PipelineKind::Reference);
}

void ReferencePipeline::learnTarget(TargetId target, TargetBuffers& buffers) {
    std::vector<DynamicVertex>& vertices = m_vertices[target];
    vertices.resize(buffers.vertexCount());
    buffers.read({0, buffers.vertexCount()}, vertices);
}

void ReferencePipeline::forgetTarget(TargetId target) {
    m_vertices.erase(target);
}

void ReferencePipeline::followWrites(TargetId target, const TargetBuffers& buffers,
                                     std::span<const VertexRange> ranges) {
    const std::span<DynamicVertex> vertices(m_vertices.at(target));
    for (const VertexRange& range : ranges) {
        buffers.read(range, vertices.subspan(range.first, range.count));
    }
}

void ReferencePipeline::deform(TargetId target, TargetBuffers& buffers, const HitBatch& batch) {
    const std::span<DynamicVertex> vertices(m_vertices.at(target));
    for (const ClusterHits& cluster : batch.clusters()) {
        const auto indices = batch.indices().subspan(cluster.firstIndex, cluster.indexCount);
        for (const std::uint32_t index : indices) {
            deformAll(vertices.subspan(cluster.firstVertex, cluster.vertexCount), batch.hits()[index]);
        }
    }
    for (const VertexRange& range : batch.ranges()) {
        buffers.write(range.first, vertices.subspan(range.first, range.count));
    }
}

}  // namespace hitscope
