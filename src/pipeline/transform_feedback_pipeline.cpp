// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/transform_feedback_pipeline.h"

#include <algorithm>
#include <utility>

#include "pipeline/vertex_bytes.h"

namespace hitscope {

namespace {

// Of a buffer texture. OpenGL promises 65,536 and softpipe says so, but reads its first ones again beyond
// these.
constexpr std::size_t kTexels = 16384;
constexpr std::size_t kIndicesPerTexel = 4;
constexpr std::size_t kTexelsPerHit = sizeof(PackedHit) / (4 * sizeof(float));
static_assert(HitBatch::kMostHits * kTexelsPerHit <= kTexels &&
              HitBatch::kMostIndices <= kIndicesPerTexel * kTexels);

// Texture units that nothing else uses, among the 16 that a vertex shader is sure to have.
constexpr GLint kHitUnit = 13;
constexpr GLint kIndexUnit = 14;
constexpr GLint kClusterUnit = 15;

void copyBack(GLuint scratch, GLuint dynamic, std::span<const VertexRange> ranges) {
    glBindBuffer(GL_COPY_READ_BUFFER, scratch);
    glBindBuffer(GL_COPY_WRITE_BUFFER, dynamic);
    GLintptr captured = 0;
    for (const VertexRange& range : ranges) {
        const GLsizeiptr bytes = vertexBytes(range.count);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, captured, vertexBytes(range.first),
                            bytes);
        captured += bytes;
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

}  // namespace

Result<std::unique_ptr<DeformationPipeline>> TransformFeedbackPipeline::create(
    const PipelineOptions& options) {
    gl::Defines defines = options.deformDefines;
    defines.emplace_back("HITSCOPE_HIT_LISTS", "1");
    Result<CapturePass> pass = CapturePass::create(defines);
    if (!pass) {
        return pass.error();
    }
    defines.emplace_back("HITSCOPE_FORMS", "1");
    Result<CapturePass> forms = CapturePass::create(std::move(defines));
    if (!forms) {
        return forms.error();
    }
    return std::unique_ptr<DeformationPipeline>(new TransformFeedbackPipeline(
        std::move(pass).value(), std::move(forms).value(), options.startsBuffersLate));
}

TransformFeedbackPipeline::TransformFeedbackPipeline(CapturePass pass, CapturePass forms, bool startsLate)
    : m_pass(std::move(pass)),
      m_forms(std::move(forms)),
      m_hits(GL_RGBA32F, sizeof(PackedHit), kTexels / kTexelsPerHit, startsLate),
      m_indices(GL_RGBA32UI, sizeof(std::uint32_t), kIndicesPerTexel * kTexels, startsLate),
      m_clusters(GL_RGBA32UI, sizeof(ClusterHits), kTexels, startsLate) {}

const PipelineTraits& TransformFeedbackPipeline::traits() const {
    return pipelineTraits(PipelineKind::TransformFeedback);
}

void TransformFeedbackPipeline::prepare(const gl::Program& program, std::size_t firstHit,
                                        std::size_t firstIndex) const {
    GLint unit = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    m_hits.bind(kHitUnit);
    m_indices.bind(kIndexUnit);
    m_clusters.bind(kClusterUnit);
    glActiveTexture(static_cast<GLenum>(unit));
    program.set("u_hits", kHitUnit);
    program.set("u_hitIndices", kIndexUnit);
    program.set("u_clusters", kClusterUnit);
    program.set("u_hitBase", static_cast<int>(firstHit));
    program.set("u_indexBase", static_cast<int>(firstIndex));
}

void TransformFeedbackPipeline::learnTarget(TargetId /*target*/, TargetBuffers& buffers) {
    buffers.needClusterNumbers();
}

void TransformFeedbackPipeline::deform(TargetId /*target*/, TargetBuffers& buffers, const HitBatch& batch) {
    const std::size_t firstHit = m_hits.write(batch.records().data(), batch.records().size());
    const std::size_t firstIndex = m_indices.write(batch.indices().data(), batch.indices().size());
    for (const auto& [pass, clusters] :
         {std::pair(&m_pass, batch.paperClusters()), {&m_forms, batch.formClusters()}}) {
        for (auto rest = clusters; !rest.empty(); rest = rest.subspan(std::min(rest.size(), kTexels))) {
            deformPart(*pass, buffers, rest.first(std::min(rest.size(), kTexels)), firstHit, firstIndex);
        }
    }
}

void TransformFeedbackPipeline::deformPart(CapturePass& pass, TargetBuffers& buffers,
                                           std::span<const ClusterHits> clusters, std::size_t firstHit,
                                           std::size_t firstIndex) {
    const auto firstCluster = static_cast<int>(m_clusters.write(clusters.data(), clusters.size()));
    m_runs.clear();
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const ClusterHits& cluster = clusters[i];
        const int base =
            firstCluster + static_cast<int>(i) - static_cast<int>(cluster.firstVertex / kClusterVertices);
        // Neighbours in the mesh are neighbours here: they have the same base.
        if (!m_runs.empty() && m_runs.back().clusterBase == base) {
            m_runs.back().range.count += cluster.vertexCount;
        } else {
            m_runs.push_back({{cluster.firstVertex, cluster.vertexCount}, base});
        }
    }
    pass.run(
        buffers, m_runs, [&](const gl::Program& program) { prepare(program, firstHit, firstIndex); },
        [&](std::span<const VertexRange> ranges) {
            copyBack(pass.scratch(), buffers.dynamicBuffer(), ranges);
        });
}

}  // namespace hitscope
