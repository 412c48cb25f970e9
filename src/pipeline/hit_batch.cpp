// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_batch.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace hitscope {

namespace {

constexpr std::size_t kRecordsPerCurve = 2;
static_assert(sizeof(CurveTerms) <= kRecordsPerCurve * sizeof(PackedHit));

}  // namespace

bool HitBatch::hasRoom(std::size_t reached) const {
    // A hit alone makes one list, however many clusters share it.
    const std::size_t records = m_hits.size() + kRecordsPerCurve * m_curves;
    return m_hits.empty() || (records < kMostHits && m_reaches.size() + reached <= kMostIndices);
}

void HitBatch::add(const Hit& hit, std::span<const std::uint32_t> reached) {
    if (reached.empty()) {
        return;
    }
    const auto index = static_cast<std::uint32_t>(m_hits.size());
    const DentShape& shape = m_hits.emplace_back(dentShapeOf(hit));
    const bool hasForm = shape.kind != DentKind::Paper;
    m_curves += shape.kind == DentKind::Curve ? 1 : 0;
    for (const std::uint32_t cluster : reached) {
        std::uint32_t& slot = m_slotOf[cluster];
        if (slot == kNoIndex) {
            slot = static_cast<std::uint32_t>(m_reached.size());
            m_reached.push_back(cluster);
            m_counts.push_back(0);
            m_slotHasForms.push_back(false);
        }
        ++m_counts[slot];
        m_slotHasForms[slot] = m_slotHasForms[slot] || hasForm;
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
    m_slotHasForms.clear();
    m_curves = 0;
    m_paperClusters = 0;
    m_records.clear();
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
    m_indices.clear();
    m_work.clear();
    for (const std::uint32_t cluster : sortedClusters()) {
        const std::uint32_t slot = m_slotOf[cluster];
        addWork(cluster, std::span(hits).subspan(starts[slot], m_counts[slot]));
    }
    pack();
}

/// Those without forms first; counts them.
std::vector<std::uint32_t> HitBatch::sortedClusters() {
    std::vector<std::uint32_t> clusters = m_reached;
    const auto forms = std::partition(clusters.begin(), clusters.end(), [this](std::uint32_t cluster) {
        return !m_slotHasForms[m_slotOf[cluster]];
    });
    std::sort(clusters.begin(), forms);
    std::sort(forms, clusters.end());
    m_paperClusters = static_cast<std::size_t>(forms - clusters.begin());
    return clusters;
}

void HitBatch::pack() {
    m_records.clear();
    m_records.resize(m_hits.size() + kRecordsPerCurve * m_curves);
    std::size_t curve = m_hits.size();
    for (std::size_t i = 0; i < m_hits.size(); ++i) {
        const DentShape& hit = m_hits[i];
        const bool hasCurve = hit.kind == DentKind::Curve;
        m_records[i] = {hit.point, hit.reach,     hit.direction,
                        hit.power, hit.magnitude, formCode(hit.kind, hasCurve ? curve : 0),
                        {}};
        if (hasCurve) {
            // Two records are 24 numbers without a gap.
            std::memcpy(static_cast<void*>(&m_records[curve]), hit.curve.data(), sizeof hit.curve);
            curve += kRecordsPerCurve;
        }
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
    std::vector<ClusterHits> sorted(m_work.size());
    std::ranges::merge(paperClusters(), formClusters(), sorted.begin(), {}, &ClusterHits::firstVertex,
                       &ClusterHits::firstVertex);
    std::vector<VertexRange> ranges;
    ranges.reserve(sorted.size());
    for (const ClusterHits& work : sorted) {
        if (!ranges.empty() && ranges.back().first + ranges.back().count == work.firstVertex) {
            ranges.back().count += work.vertexCount;
        } else {
            ranges.push_back({work.firstVertex, work.vertexCount});
        }
    }
    return ranges;
}

}  // namespace hitscope
