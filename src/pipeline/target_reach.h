// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deform/cluster_reach.h"

namespace hitscope {

/// Which of a target's clusters a hit can reach, for a pipeline that reads its vertices back. Between two
/// reads ClusterReach's spheres grow by what hits could do, and grown spheres are found by more hits, which
/// grow them more; after a read they are drawn tight around where the vertices really are. Without that, some
/// hundred hits all over a target make every hit reach all of it.
class TargetReach {
public:
    /// `clusters` (of the original) outlive this.
    explicit TargetReach(std::span<const Cluster> clusters);

    /// As ClusterReach::advance(): whole clusters.
    [[nodiscard]] std::vector<VertexRange> advance(const Hit& hit) { return m_reach.advance(hit); }
    [[nodiscard]] std::span<const Cluster> clusters() const { return m_clusters; }

    /// Vertices [first, first + vertices.size()) are now as given. Call for all that have changed, then
    /// update(). Clusters given in part keep what they had and grow.
    void place(std::uint32_t first, std::span<const DynamicVertex> vertices);
    /// What was placed counts from here on. Costs time in proportion to the clusters.
    void update() { m_reach = ClusterReach(m_clusters); }
    /// Every vertex is back at its original.
    void reset();

private:
    std::span<const Cluster> m_original;
    std::vector<Cluster> m_clusters;
    ClusterReach m_reach;
};

}  // namespace hitscope
