// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_batch.h"

#include <algorithm>

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
        m_reaches.push_back({cluster, index});
    }
}

void HitBatch::clear() {
    m_hits.clear();
    m_reaches.clear();
    m_indices.clear();
    m_work.clear();
}

void HitBatch::finish() {
    // One hit's clusters come sorted.
    if (m_hits.size() > 1) {
        std::stable_sort(m_reaches.begin(), m_reaches.end(),
                         [](const Reach& a, const Reach& b) { return a.cluster < b.cluster; });
    }
    m_indices.clear();
    m_work.clear();
    for (std::size_t begin = 0; begin < m_reaches.size();) {
        const Cluster& cluster = m_clusters[m_reaches[begin].cluster];
        ClusterHits work{cluster.first, cluster.count, static_cast<std::uint32_t>(m_indices.size()), 0};
        std::size_t end = begin;
        for (; end < m_reaches.size() && m_reaches[end].cluster == m_reaches[begin].cluster; ++end) {
            m_indices.push_back(m_reaches[end].hit);
        }
        work.indexCount = static_cast<std::uint32_t>(end - begin);
        shareIndices(work);
        m_work.push_back(work);
        begin = end;
    }
}

/// Neighbours are often reached by the same hits: then they have one list.
void HitBatch::shareIndices(ClusterHits& work) {
    if (m_work.empty() || m_work.back().indexCount != work.indexCount) {
        return;
    }
    const auto mine = m_indices.begin() + work.firstIndex;
    const auto neighbours = m_indices.begin() + m_work.back().firstIndex;
    if (std::equal(mine, m_indices.end(), neighbours)) {
        m_indices.erase(mine, m_indices.end());
        work.firstIndex = m_work.back().firstIndex;
    }
}

std::vector<ClusterHits> HitBatch::runs() const {
    std::vector<ClusterHits> runs;
    runs.reserve(m_work.size());
    for (const ClusterHits& work : m_work) {
        if (!runs.empty() && runs.back().firstIndex == work.firstIndex &&
            runs.back().firstVertex + runs.back().vertexCount == work.firstVertex) {
            runs.back().vertexCount += work.vertexCount;
        } else {
            runs.push_back(work);
        }
    }
    return runs;
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
