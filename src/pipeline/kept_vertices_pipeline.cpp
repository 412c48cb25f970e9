// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/kept_vertices_pipeline.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "deform/hit_bounds.h"

namespace hitscope {

namespace {

/// Hits between two looks at where the vertices are, when many are applied at once. Knowing that keeps a hit
/// from being tried on clusters that could only have been pushed in its way.
constexpr std::size_t kBulkHits = 256;
/// Hits applied again at most after going back; beyond, going through the clusters concerned is cheaper.
constexpr std::size_t kMostRepeated = 256;

}  // namespace

void KeptVerticesPipeline::addTarget(TargetId target, TargetBuffers& buffers) {
    removeTarget(target);
    TargetState& state = m_targets.emplace(target, TargetState(target, buffers, ++m_lastEpoch)).first->second;
    learnTarget(target, buffers);
    append(state, 0, Arrival::Bulk);
}

void KeptVerticesPipeline::removeTarget(TargetId target) {
    if (m_targets.erase(target) > 0) {
        m_undo.forget(target);
        forgetTarget(target);
    }
}

void KeptVerticesPipeline::startOver(std::span<const Hit> history) {
    m_hits.reset(history);
    for (auto& [id, target] : m_targets) {
        const std::vector<VertexRange> moved = target.moved.take();
        target.buffers->restoreOriginal(moved);
        target.reach.restart();
        m_undo.forget(id);
        rewritten(target, moved);
        append(target, 0, Arrival::Bulk);
    }
}

void KeptVerticesPipeline::follow(const HistoryEdit& edit) {
    for (const TargetHitsEdit& change : m_hits.apply(edit)) {
        const auto target = m_targets.find(change.target);
        if (target != m_targets.end()) {
            this->change(target->second, change);
        }
    }
}

void KeptVerticesPipeline::change(TargetState& target, const TargetHitsEdit& edit) {
    if (edit.before.empty() && edit.first + edit.after.size() == m_hits.of(target.id).size()) {
        append(target, edit.first, Arrival::Live);
        return;
    }
    target.reach.limitMoved(
        changedBy(edit.before, edit.after, m_hits.of(target.id).subspan(edit.first + edit.after.size())));
    if (!goBack(target, edit)) {
        redo(target, edit);
    }
    target.reach.limitMoved(std::nullopt);
}

/// Applies the target's hits [firstHit, ...), which come after all those before.
void KeptVerticesPipeline::append(TargetState& target, std::size_t firstHit, Arrival arrival) {
    const std::span<const Hit> hits = m_hits.of(target.id);
    std::size_t begin = firstHit;
    for (std::size_t i = firstHit; i < hits.size(); ++i) {
        target.reached.clear();
        target.reach.advance(hits[i], target.reached);
        if (!target.batch.hasRoom(target.reached.size())) {
            flush(target, std::exchange(begin, i), arrival);
        }
        target.batch.add(hits[i], target.reached);
        // Hits as they arrive never wait for the GPU.
        if (arrival == Arrival::Bulk && target.batch.hits().size() == kBulkHits && i + 1 < hits.size()) {
            tighten(target, flush(target, begin, arrival));
            begin = i + 1;
        }
    }
    flush(target, begin, arrival);
}

/// Applies the batch, whose first hit is `firstHit` or a later one. Returns what it reached, sorted and
/// merged.
std::vector<VertexRange> KeptVerticesPipeline::flush(TargetState& target, std::size_t firstHit,
                                                     Arrival arrival) {
    if (target.batch.empty()) {
        return {};
    }
    target.batch.finish();
    std::vector<VertexRange> ranges = target.batch.ranges();
    if (arrival == Arrival::Live) {
        m_undo.save(target.id, target.buffers->dynamicBuffer(), firstHit, ranges);
    }
    deform(target.id, *target.buffers, target.batch);
    target.batch.clear();
    target.moved.add(ranges);
    target.unread.add(ranges);
    return ranges;
}

/// Takes the last hits back and applies what now comes after.
bool KeptVerticesPipeline::goBack(TargetState& target, const TargetHitsEdit& edit) {
    const std::optional<std::size_t> firstHit = m_undo.reachableBefore(target.id, edit.first);
    if (!firstHit || m_hits.of(target.id).size() - *firstHit > kMostRepeated) {
        return false;
    }
    const std::vector<VertexRange> ranges =
        m_undo.goBack(target.id, target.buffers->dynamicBuffer(), *firstHit);
    target.reach.goBack(target.reach.clustersIn(ranges));
    rewritten(target, ranges);
    append(target, *firstHit, Arrival::Live);
    return true;
}

/// Vertices do not influence one another: only those in clusters that a hit taken out or put in may have
/// reached can come out otherwise, and they are taken from their originals through all hits again.
void KeptVerticesPipeline::redo(TargetState& target, const TargetHitsEdit& edit) {
    m_undo.forget(target.id);
    target.epoch = ++m_lastEpoch;
    const std::vector<std::uint32_t> concerned = target.reach.everReached(edit.before, edit.after);
    if (concerned.empty()) {
        return;
    }
    const std::vector<VertexRange> ranges = target.reach.rangesOf(concerned);
    target.buffers->restoreOriginal(ranges);
    target.reach.restart(concerned);
    rewritten(target, ranges);

    for (const Hit& hit : m_hits.of(target.id)) {
        target.reached.clear();
        target.reach.advanceWithin(concerned, hit, target.reached);
        if (!target.batch.hasRoom(target.reached.size())) {
            flush(target, 0, Arrival::Bulk);
        }
        target.batch.add(hit, target.reached);
        if (target.batch.hits().size() == kBulkHits) {
            tighten(target, flush(target, 0, Arrival::Bulk));
        }
    }
    flush(target, 0, Arrival::Bulk);
}

/// Looks where these vertices are. Waits for the GPU.
void KeptVerticesPipeline::tighten(TargetState& target, std::span<const VertexRange> ranges) {
    std::vector<DynamicVertex> vertices;
    for (const VertexRange& range : ranges) {
        vertices.resize(range.count);
        target.buffers->read(range, vertices);
        target.reach.place(range.first, vertices);
    }
}

/// The vertices in `ranges` were put back to an earlier state.
void KeptVerticesPipeline::rewritten(TargetState& target, std::span<const VertexRange> ranges) {
    target.epoch = ++m_lastEpoch;
    target.unread.add(ranges);
    followWrites(target.id, *target.buffers, ranges);
}

void KeptVerticesPipeline::requestReadBack(std::size_t most) {
    std::vector<ReadBackQueue::Part> parts;
    for (auto& [id, target] : m_targets) {
        if (!target.unread.empty() && most > 0) {
            parts.push_back({.target = id,
                             .buffer = target.buffers->dynamicBuffer(),
                             .ranges = target.unread.take(most),
                             .moment = {m_hits.of(id).size(), target.epoch}});
            most -= std::min(most, vertexCount(parts.back().ranges));
        }
    }
    m_readBack.request(std::move(parts));
}

/// Where the vertices are is learned on the way: boxes drawn tight around what has been, and grown by the
/// hits since.
ReadBackQueue::Take KeptVerticesPipeline::delivery(const ReadBackSink& sink) {
    return [this, &sink](const ReadBackQueue::Part& part, std::uint32_t first,
                         std::span<const DynamicVertex> vertices) {
        const auto known = m_targets.find(part.target);
        if (known == m_targets.end() || part.moment.epoch < known->second.born) {
            return;
        }
        if (known->second.epoch == part.moment.epoch) {
            known->second.reach.place(first, vertices, m_hits.of(part.target).subspan(part.moment.hits));
        }
        sink(part.target, first, vertices);
    };
}

void KeptVerticesPipeline::readBack(const ReadBackSink& sink) {
    requestReadBack(std::numeric_limits<std::size_t>::max());
    m_readBack.takeAll(delivery(sink));
}

void KeptVerticesPipeline::pollReadBack(const ReadBackSink& sink) {
    requestReadBack(kMostAPoll);
    m_readBack.takeArrived(delivery(sink));
}

bool KeptVerticesPipeline::isReadBackPending() const {
    return !m_readBack.empty() || std::any_of(m_targets.begin(), m_targets.end(),
                                              [](const auto& entry) { return !entry.second.unread.empty(); });
}

const ClusterReach* KeptVerticesPipeline::reach(TargetId target) const {
    const auto found = m_targets.find(target);
    return found == m_targets.end() ? nullptr : &found->second.reach;
}

}  // namespace hitscope
