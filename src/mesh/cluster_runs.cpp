// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cluster_runs.h"

#include <algorithm>

#include "core/give_up.h"
#include "mesh/render_mesh.h"

namespace hitscope {

ClusterRuns::ClusterRuns(std::span<const DynamicVertex> vertices, std::span<const std::uint32_t> indices,
                         std::size_t corners, std::span<const DrawRange> draws, std::size_t before) {
    std::vector<std::size_t> knownTo;  // by cluster: one more than the last run with a corner there
    const auto addRange = [&](std::size_t first, std::size_t end) {
        for (std::size_t element = first; element < end; element += corners) {
            mayGiveUp(element / corners);
            const std::span<const std::uint32_t> ends = indices.subspan(element, corners);
            const auto [lowest, highest] = std::minmax_element(ends.begin(), ends.end());
            // All clusters but the last are full.
            const std::uint32_t cluster = *lowest / kClusterVertices;
            if (element == first || m_runs.back().cluster != cluster) {
                const auto index = static_cast<std::uint32_t>(before + element);
                m_runs.push_back({index, index, cluster, static_cast<std::uint32_t>(m_others.size()), {}});
            }
            m_runs.back().end = static_cast<std::uint32_t>(before + element + corners);
            for (const std::uint32_t vertex : ends) {
                m_runs.back().bounds.add(vertices[vertex].position);
            }
            if (*highest / kClusterVertices == cluster) {
                continue;
            }
            knownTo.resize(std::max(knownTo.size(), std::size_t{*highest} / kClusterVertices + 1));
            for (const std::uint32_t vertex : ends) {
                const std::uint32_t other = vertex / kClusterVertices;
                if (other != cluster && knownTo[other] != m_runs.size()) {
                    knownTo[other] = m_runs.size();
                    m_others.push_back(other);
                }
            }
        }
    };
    if (draws.empty()) {
        addRange(0, indices.size());
    }
    for (const DrawRange& draw : draws) {
        addRange(draw.first, std::size_t{draw.first} + draw.count);
    }
    m_runs.shrink_to_fit();
    m_others.shrink_to_fit();
}

}  // namespace hitscope
