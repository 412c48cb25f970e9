// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/vertex_copy.h"

#include <algorithm>
#include <new>

namespace hitscope {

VertexCopy::VertexCopy(const RenderMesh& mesh)
    : m_mesh(&mesh), m_isCopied(mesh.clusters.size(), false), m_left(mesh.clusters.size()) {
    if (!mesh.vertices.empty()) {
        // Not a vector, which would write to all of it.
        m_vertices.reset(
            static_cast<DynamicVertex*>(std::malloc(mesh.vertices.size() * sizeof(DynamicVertex))));
        if (!m_vertices) {
            throw std::bad_alloc();
        }
    }
}

void VertexCopy::restore(std::uint32_t cluster) {
    const Cluster& run = m_mesh->clusters[cluster];
    std::uninitialized_copy_n(m_mesh->vertices.data() + run.first, run.count, m_vertices.get() + run.first);
    if (!m_isCopied[cluster]) {
        m_isCopied[cluster] = true;
        --m_left;
    }
}

void VertexCopy::copy(std::uint32_t cluster) {
    if (!m_isCopied[cluster]) {
        restore(cluster);
    }
}

std::span<DynamicVertex> VertexCopy::cluster(std::uint32_t index) {
    copy(index);
    const Cluster& run = m_mesh->clusters[index];
    return {m_vertices.get() + run.first, run.count};
}

std::span<const DynamicVertex> VertexCopy::range(const VertexRange& range) {
    if (m_left > 0) {
        const std::vector<Cluster>& clusters = m_mesh->clusters;
        const auto behind = std::upper_bound(
            clusters.begin(), clusters.end(), range.first,
            [](std::uint32_t vertex, const Cluster& cluster) { return vertex < cluster.first; });
        auto cluster = static_cast<std::uint32_t>(behind - clusters.begin());
        cluster -= cluster > 0 ? 1 : 0;
        for (; cluster < clusters.size() && clusters[cluster].first < range.first + range.count; ++cluster) {
            copy(cluster);
        }
    }
    return {m_vertices.get() + range.first, range.count};
}

std::vector<std::uint32_t> VertexCopy::copied() const {
    std::vector<std::uint32_t> clusters;
    for (std::uint32_t cluster = 0; cluster < m_isCopied.size(); ++cluster) {
        if (m_isCopied[cluster]) {
            clusters.push_back(cluster);
        }
    }
    return clusters;
}

}  // namespace hitscope
