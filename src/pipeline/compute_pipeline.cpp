// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/compute_pipeline.h"

#include <algorithm>
#include <utility>

#include "pipeline/vertex_bytes.h"

namespace hitscope {

namespace {

constexpr std::size_t kHits = 4 * HitBatch::kMostHits;
constexpr std::size_t kClusters = 32768;  // in one dispatch; OpenGL allows 65,535 groups at least

/// Where a part of the dynamic buffer that is bound may start: drivers ask for multiples of 256 bytes at
/// most.
constexpr std::size_t kStep = 32;
static_assert(kStep * sizeof(DynamicVertex) % 256 == 0);

/// The bindings in deform.comp.
enum Binding : GLuint { Vertices, Hits, Indices, Clusters };

/// Puts the caller's program back, and leaves no storage buffer bound.
class KeepState {
public:
    KeepState() { glGetIntegerv(GL_CURRENT_PROGRAM, &m_program); }
    ~KeepState() {
        glUseProgram(static_cast<GLuint>(m_program));
        for (const GLuint binding : {Vertices, Hits, Indices, Clusters}) {
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, 0);
        }
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    }
    KeepState(const KeepState&) = delete;
    KeepState& operator=(const KeepState&) = delete;

private:
    GLint m_program = 0;
};

std::size_t bindableVertices() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes) / sizeof(DynamicVertex);
}

}  // namespace

Result<std::unique_ptr<DeformationPipeline>> ComputePipeline::create(const PipelineOptions& options) {
    Result<gl::Program> program =
        gl::Program::build({.defines = options.deformDefines, .compute = "deform.comp"});
    if (!program) {
        return program.error();
    }
    gl::Defines defines = options.deformDefines;
    defines.emplace_back("HITSCOPE_FORMS", "1");
    Result<gl::Program> forms = gl::Program::build({.defines = std::move(defines), .compute = "deform.comp"});
    if (!forms) {
        return forms.error();
    }
    return std::unique_ptr<DeformationPipeline>(
        new ComputePipeline(std::move(program).value(), std::move(forms).value()));
}

ComputePipeline::ComputePipeline(gl::Program program, gl::Program forms)
    : m_program(std::move(program)),
      m_forms(std::move(forms)),
      m_hits(sizeof(PackedHit), kHits),
      m_indices(sizeof(std::uint32_t), 2 * HitBatch::kMostIndices),
      m_clusters(sizeof(ClusterHits), 2 * kClusters),
      m_bindableVertices(bindableVertices()) {}

const PipelineTraits& ComputePipeline::traits() const {
    return pipelineTraits(PipelineKind::Compute);
}

void ComputePipeline::deform(TargetId /*target*/, TargetBuffers& buffers, const HitBatch& batch) {
    const KeepState keep;
    const auto firstHit = static_cast<int>(m_hits.write(batch.records().data(), batch.records().size()));
    const auto firstIndex = static_cast<int>(m_indices.write(batch.indices().data(), batch.indices().size()));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, Hits, m_hits.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, Indices, m_indices.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, Clusters, m_clusters.id());

    for (const auto& [program, clusters] :
         {std::pair(&m_program, batch.paperClusters()), {&m_forms, batch.formClusters()}}) {
        if (!clusters.empty()) {
            program->use();
            program->set("u_hitBase", firstHit);
            program->set("u_indexBase", firstIndex);
            dispatchAll(*program, buffers, clusters);
        }
    }
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT | GL_TRANSFORM_FEEDBACK_BARRIER_BIT);
}

/// As many at once as may be bound.
void ComputePipeline::dispatchAll(const gl::Program& program, const TargetBuffers& buffers,
                                  std::span<const ClusterHits> clusters) {
    std::span<const ClusterHits> rest = clusters;
    while (!rest.empty()) {
        const std::size_t first = rest.front().firstVertex / kStep * kStep;
        const auto tooFar = [&](const ClusterHits& cluster) {
            return cluster.firstVertex + cluster.vertexCount - first > m_bindableVertices;
        };
        const auto part = rest.first(std::min(rest.size(), kClusters));
        const auto end = std::find_if(part.begin(), part.end(), tooFar);
        const auto count = static_cast<std::size_t>(end - part.begin());
        dispatch(program, buffers, rest.first(count));
        rest = rest.subspan(count);
    }
}

void ComputePipeline::dispatch(const gl::Program& program, const TargetBuffers& buffers,
                               std::span<const ClusterHits> clusters) {
    const std::size_t first = clusters.front().firstVertex / kStep * kStep;
    const std::size_t end = clusters.back().firstVertex + clusters.back().vertexCount;
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, Vertices, buffers.dynamicBuffer(), vertexBytes(first),
                      vertexBytes(end - first));
    program.set("u_firstVertex", static_cast<int>(first));
    program.set("u_clusterBase", static_cast<int>(m_clusters.write(clusters.data(), clusters.size())));
    glDispatchCompute(static_cast<GLuint>(clusters.size()), 1, 1);
}

}  // namespace hitscope
