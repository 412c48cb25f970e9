// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/uniform_array_pipeline.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <utility>

namespace hitscope {
namespace {

/// Never the same twice, so that a program tells whose arrays it has, and in which state.
std::uint64_t nextStamp() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

int vertexUniformComponents(const PipelineLimits& limits) {
    if (limits.vertexUniformComponents) {
        return *limits.vertexUniformComponents;
    }
    GLint components = 0;
    glGetIntegerv(GL_MAX_VERTEX_UNIFORM_COMPONENTS, &components);
    return components;
}

}  // namespace

Result<std::unique_ptr<DeformationPipeline>> UniformArrayPipeline::create(const PipelineLimits& limits) {
    const int components = vertexUniformComponents(limits);
    // OpenGL leaves it to the driver how densely arrays are packed. The capturing program has arrays that
    // take up the other programs' share as well: if it links, they will.
    std::size_t capacity = hitsThatFit(components, UniformPacking::Tight);
    Result<CapturePass> pass = CapturePass::create(capacity + kOtherUniformsInHits);
    if (!pass) {
        capacity = hitsThatFit(components, UniformPacking::Registers);
        pass = CapturePass::create(capacity);
    }
    if (!pass) {
        return pass.error();
    }
    return std::unique_ptr<DeformationPipeline>(new UniformArrayPipeline(std::move(pass).value(), capacity));
}

UniformArrayPipeline::UniformArrayPipeline(CapturePass pass, std::size_t capacity)
    : m_pass(std::move(pass)), m_capacity(capacity), m_arrays(capacity), m_stamp(nextStamp()) {}

const PipelineTraits& UniformArrayPipeline::traits() const {
    return pipelineTraits(PipelineKind::UniformArray);
}

void UniformArrayPipeline::addTarget(TargetId target, TargetBuffers& buffers) {
    removeTarget(target);
    m_targets.emplace(target, TargetState(buffers));
}

void UniformArrayPipeline::removeTarget(TargetId target) {
    if (m_targets.erase(target) > 0) {
        std::erase_if(m_hits, [target](const Hit& hit) { return hit.target == target; });
        fillArrays();
    }
}

void UniformArrayPipeline::reset(std::span<const Hit> history) {
    m_hits.clear();
    m_dropped = 0;
    for (auto& [id, target] : m_targets) {
        target.unread.add(target.moved.take());
        target.reach.reset();
    }
    append(history);
}

void UniformArrayPipeline::append(std::span<const Hit> hits) {
    for (const Hit& hit : hits) {
        const auto target = m_targets.find(hit.target);
        if (target != m_targets.end()) {
            m_hits.push_back(hit);
            const std::vector<VertexRange> reached = target->second.reach.advance(hit);
            target->second.moved.add(reached);
            target->second.unread.add(reached);
        }
        if (m_hits.size() > 2 * m_capacity) {
            dropOldest();  // a long history passes through without being held
        }
    }
    dropOldest();
    fillArrays();
}

/// The newest hits that the arrays hold, the palette of their constants included.
std::size_t UniformArrayPipeline::hitsToKeep() const {
    std::vector<DeformationConstants> palette;
    std::size_t kept = 0;
    for (auto newest = m_hits.rbegin(); newest != m_hits.rend() && kept < m_capacity; ++newest, ++kept) {
        const DeformationConstants& constants = newest->constants;
        if (std::find(palette.begin(), palette.end(), constants) == palette.end()) {
            if (palette.size() == kHitConstants) {
                break;
            }
            palette.push_back(constants);
        }
    }
    return kept;
}

/// Without the dropped hits a vertex may take another way, past other hits; only one that no hit has ever
/// moved surely stays where it is.
void UniformArrayPipeline::dropOldest() {
    const std::size_t kept = hitsToKeep();
    std::set<TargetId> concerned;
    for (; m_hits.size() > kept; ++m_dropped) {
        concerned.insert(m_hits.front().target);
        m_hits.pop_front();
    }
    for (const TargetId id : concerned) {
        TargetState& target = m_targets.at(id);
        target.unread.add(target.moved.ranges());
    }
}

/// A target's hits stand together, in their order; targets do not influence one another.
void UniformArrayPipeline::fillArrays() {
    std::unordered_map<TargetId, std::vector<const Hit*>> hitsOf;
    for (const Hit& hit : m_hits) {
        hitsOf[hit.target].push_back(&hit);
    }
    m_arrays.clear();
    for (auto& [id, target] : m_targets) {
        target.firstHit = m_arrays.size();
        for (const Hit* hit : hitsOf[id]) {
            static_cast<void>(m_arrays.add(*hit));  // hitsToKeep() has seen to it that there is room
        }
        target.lastHit = m_arrays.size();
    }
    m_stamp = nextStamp();
    m_captureIsCurrent = false;
}

void UniformArrayPipeline::readBack(const ReadBackSink& sink) {
    std::vector<DynamicVertex> vertices;
    for (auto& entry : m_targets) {  // clang 14 cannot capture structured bindings
        const TargetId id = entry.first;
        TargetState& target = entry.second;
        if (target.unread.empty()) {
            continue;
        }
        if (!std::exchange(m_captureIsCurrent, true)) {
            m_pass.upload(m_arrays);
        }
        const CaptureRun run{target.unread.take(), target.firstHit, target.lastHit};
        m_pass.run(*target.buffers, std::span(&run, 1), [&](std::span<const VertexRange> ranges) {
            GLintptr captured = 0;
            for (const VertexRange& range : ranges) {
                vertices.resize(range.count);
                const auto bytes = static_cast<GLsizeiptr>(range.count * sizeof(DynamicVertex));
                glBindBuffer(GL_COPY_READ_BUFFER, m_pass.scratch());
                glGetBufferSubData(GL_COPY_READ_BUFFER, captured, bytes, vertices.data());
                glBindBuffer(GL_COPY_READ_BUFFER, 0);
                captured += bytes;
                target.reach.place(range.first, vertices);
                sink(id, range.first, vertices);
            }
        });
        target.reach.update();
    }
}

void UniformArrayPipeline::prepareDraw(const gl::Program& program, TargetId target) {
    if (program.contentStamp() != m_stamp) {
        m_arrays.upload(program);
        program.setContentStamp(m_stamp);
    }
    const auto known = m_targets.find(target);
    program.set("u_firstHit", known == m_targets.end() ? 0 : static_cast<int>(known->second.firstHit));
    program.set("u_lastHit", known == m_targets.end() ? 0 : static_cast<int>(known->second.lastHit));
}

}  // namespace hitscope
