// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_batch.h"

#include <algorithm>
#include <numeric>

namespace hitscope {

bool HitBatch::hasRoom(std::size_t reached) const {
    // A hit alone makes one list, however many clusters share it.
    return m_hits.empty() || (m_hits.size() < kMostHits && m_reaches.size() + reached <= kMostIndices);
}

void HitBatch::add(const Hit& hit, std::span<const std::uint32_t> reached) {
    if (reached.empty()) {
        return;
    }
    const auto index = static_cast<std::uint32_t>(m_hits.size());
    m_hits.push_back({hit.point,
                      hit.constants.maxDistance,
                      hit.direction,
                      hit.constants.power,
                      hit.constants.maxMagnitude,
                      {}});
    for (const std::uint32_t cluster : reached) {
        std::uint32_t& slot = m_slotOf[cluster];
        if (slot == kNoIndex) {
            slot = static_cast<std::uint32_t>(m_reached.size());
            m_reached.push_back(cluster);
            m_counts.push_back(0);
        }
        ++m_counts[slot];
        m_reaches.push_back({slot, index});
    }
}

void HitBatch::clear() {
    for (const std::uint32_t cluster : m_reached) {
        m_slotOf[cluster] = kNoIndex;
    }
    m_reached.clear();
    m_counts.clear();
    m_hits.clear();
    m_reaches.clear();
    m_indices.clear();
    m_work.clear();
}

/// A counting sort: the hits of a cluster stay in their order.
void HitBatch::finish() {
    std::vector<std::uint32_t> starts(m_counts.size());
    std::exclusive_scan(m_counts.begin(), m_counts.end(), starts.begin(), 0u);
    std::vector<std::uint32_t> next = starts;
    std::vector<std::uint32_t> hits(m_reaches.size());
    for (const Reach& reach : m_reaches) {
        hits[next[reach.slot]++] = reach.hit;
    }
    std::vector<std::uint32_t> clusters = m_reached;
    std::sort(clusters.begin(), clusters.end());
    m_indices.clear();
    m_work.clear();
    for (const std::uint32_t cluster : clusters) {
        const std::uint32_t slot = m_slotOf[cluster];
        addWork(cluster, std::span(hits).subspan(starts[slot], m_counts[slot]));
    }
}

/// Neighbours are often reached by the same hits: then they have one list.
void HitBatch::addWork(std::uint32_t cluster, std::span<const std::uint32_t> hits) {
    ClusterHits work{m_clusters[cluster].first, m_clusters[cluster].count,
                     static_cast<std::uint32_t>(m_indices.size()), static_cast<std::uint32_t>(hits.size())};
    if (!m_work.empty() && m_work.back().indexCount == work.indexCount &&
        std::equal(hits.begin(), hits.end(), m_indices.begin() + m_work.back().firstIndex)) {
        work.firstIndex = m_work.back().firstIndex;
    } else {
        m_indices.insert(m_indices.end(), hits.begin(), hits.end());
    }
    m_work.push_back(work);
}

std::vector<VertexRange> HitBatch::ranges() const {
    std::vector<VertexRange> ranges;
    ranges.reserve(m_work.size());
    for (const ClusterHits& work : m_work) {
        if (!ranges.empty() && ranges.back().first + ranges.back().count == work.firstVertex) {
            ranges.back().count += work.vertexCount;
        } else {
            ranges.push_back({work.firstVertex, work.vertexCount});
        }
    }
    return ranges;
}

}  // namespace hitscope
