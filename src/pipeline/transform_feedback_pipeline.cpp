// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/transform_feedback_pipeline.h"

#include <algorithm>
#include <utility>

#include "pipeline/reach_groups.h"

namespace hitscope {

namespace {

constexpr std::size_t kBatchHits = 64;  // a program of that many fits the least uniform space GL 3.3 has

/// Calls take(first, vertices) for each range of the dynamic buffer. Waits for the GPU.
template <class Take>
void readVertices(const TargetBuffers& buffers, std::span<const VertexRange> ranges, const Take& take) {
    std::vector<DynamicVertex> vertices;
    for (const VertexRange& range : ranges) {
        vertices.resize(range.count);
        glBindBuffer(GL_COPY_READ_BUFFER, buffers.dynamicBuffer());
        glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(range.first * sizeof(DynamicVertex)),
                           static_cast<GLsizeiptr>(range.count * sizeof(DynamicVertex)), vertices.data());
        glBindBuffer(GL_COPY_READ_BUFFER, 0);
        take(range.first, std::span<const DynamicVertex>(vertices));
    }
}

}  // namespace

Result<std::unique_ptr<DeformationPipeline>> TransformFeedbackPipeline::create() {
    Result<CapturePass> pass = CapturePass::create(kBatchHits);
    if (!pass) {
        return pass.error();
    }
    return std::unique_ptr<DeformationPipeline>(new TransformFeedbackPipeline(std::move(pass).value()));
}

TransformFeedbackPipeline::TransformFeedbackPipeline(CapturePass pass)
    : m_pass(std::move(pass)), m_batch(kBatchHits) {}

const PipelineTraits& TransformFeedbackPipeline::traits() const {
    return pipelineTraits(PipelineKind::TransformFeedback);
}

void TransformFeedbackPipeline::addTarget(TargetId target, TargetBuffers& buffers) {
    m_targets.insert_or_assign(target, TargetState(buffers));
}

void TransformFeedbackPipeline::removeTarget(TargetId target) {
    m_targets.erase(target);
}

void TransformFeedbackPipeline::reset(std::span<const Hit> history) {
    for (auto& [id, target] : m_targets) {
        const std::vector<VertexRange> moved = target.moved.take();
        target.buffers->restoreOriginal(moved);
        target.unread.add(moved);
        target.reach.reset();
    }
    append(history);
}

void TransformFeedbackPipeline::append(std::span<const Hit> hits) {
    // Targets do not influence one another: each takes its own hits, in their order.
    std::unordered_map<TargetId, std::vector<const Hit*>> hitsOf;
    for (const Hit& hit : hits) {
        if (m_targets.contains(hit.target)) {
            hitsOf[hit.target].push_back(&hit);
        }
    }
    for (const auto& [id, own] : hitsOf) {
        apply(m_targets.at(id), own);
    }
}

void TransformFeedbackPipeline::apply(TargetState& target, std::span<const Hit* const> hits) {
    while (!hits.empty()) {
        const std::size_t count = std::min(hits.size(), kBatchHits);
        const std::vector<VertexRange> reached = applyBatch(target, hits.first(count));
        hits = hits.subspan(count);
        // Hits as they arrive never wait for the GPU. A long history does, now and then, since knowing where
        // the vertices are saves most of its work.
        if (!hits.empty()) {
            readVertices(*target.buffers, reached,
                         [&](std::uint32_t first, std::span<const DynamicVertex> vertices) {
                             target.reach.place(first, vertices);
                         });
            target.reach.update();
        }
    }
}

/// Returns what the hits reach, sorted and merged.
std::vector<VertexRange> TransformFeedbackPipeline::applyBatch(TargetState& target,
                                                               std::span<const Hit* const> hits) {
    std::vector<CaptureRun> runs;
    ChangedRanges reached;
    for (const ReachGroup& group : groupByReach(target.reach, hits)) {
        reached.add(group.ranges);
        // A batch that is full is captured and copied back before the group's next hits are applied.
        for (std::size_t next = 0; next < group.hits.size();) {
            const std::size_t first = m_batch.size();
            while (next < group.hits.size() && m_batch.add(*hits[group.hits[next]])) {
                ++next;
            }
            if (m_batch.size() > first) {
                runs.push_back({group.ranges, first, m_batch.size()});
            }
            if (next < group.hits.size()) {
                flush(target, runs);
            }
        }
    }
    flush(target, runs);
    std::vector<VertexRange> ranges = reached.take();
    target.moved.add(ranges);
    target.unread.add(ranges);
    return ranges;
}

void TransformFeedbackPipeline::flush(TargetState& target, std::vector<CaptureRun>& runs) {
    if (runs.empty()) {
        return;
    }
    m_pass.upload(m_batch);
    m_pass.run(*target.buffers, runs, [&](std::span<const VertexRange> ranges) {
        glBindBuffer(GL_COPY_READ_BUFFER, m_pass.scratch());
        glBindBuffer(GL_COPY_WRITE_BUFFER, target.buffers->dynamicBuffer());
        GLintptr captured = 0;
        for (const VertexRange& range : ranges) {
            const auto bytes = static_cast<GLsizeiptr>(range.count * sizeof(DynamicVertex));
            glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, captured,
                                static_cast<GLintptr>(range.first * sizeof(DynamicVertex)), bytes);
            captured += bytes;
        }
        glBindBuffer(GL_COPY_READ_BUFFER, 0);
        glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    });
    m_batch.clear();
    runs.clear();
}

void TransformFeedbackPipeline::readBack(const ReadBackSink& sink) {
    for (auto& entry : m_targets) {  // clang 14 cannot capture structured bindings
        const TargetId id = entry.first;
        TargetState& target = entry.second;
        if (target.unread.empty()) {
            continue;
        }
        readVertices(*target.buffers, target.unread.take(),
                     [&](std::uint32_t first, std::span<const DynamicVertex> vertices) {
                         target.reach.place(first, vertices);
                         sink(id, first, vertices);
                     });
        target.reach.update();
    }
}

// The dynamic buffer holds the deformed vertices: there is nothing to tell a program.
void TransformFeedbackPipeline::prepareDraw(const gl::Program& /*program*/, TargetId /*target*/) {}

}  // namespace hitscope
