// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "core/page_vector.h"
#include "deform/hit.h"
#include "deform/vertex_range.h"
#include "mesh/render_mesh.h"

namespace hitscope {

struct HitReach;

/// Which clusters of a target a hit can reach, as its vertices move.
///
/// Each cluster has two boxes. One holds its vertices as they are: a hit grows it by what it can do to the
/// part within its reach, and where vertices are known (read back, or because the CPU moves them) it is drawn
/// tight. The other holds every place they have been at since their original, so that the vertices a hit in
/// the middle of the history has reached, or would have, can be told. Trees over both make a query cost what
/// it finds, not what the mesh has.
class ClusterReach {
public:
    /// `clusters` outlive this. Their vertices are at their original. `tree`: of them; made where there are
    /// none.
    explicit ClusterReach(std::span<const Cluster> clusters,
                          std::shared_ptr<const ClusterTree> tree = nullptr);
    /// Of a mesh that outlives this.
    explicit ClusterReach(const RenderMesh& mesh) : ClusterReach(mesh.clusters, mesh.clusterTree) {}

    [[nodiscard]] std::span<const Cluster> clusters() const { return m_clusters; }
    /// A box that holds all vertices, as they are and were. Metres, local frame.
    [[nodiscard]] Bounds bounds() const { return nodeBounds(1); }
    /// Likewise, of one cluster.
    [[nodiscard]] Bounds bounds(std::size_t cluster) const { return nodeBounds(m_leaves + cluster); }

    /// Boxes that hold the vertices as they are, as far as is known: drawn tight once they have been looked
    /// at.
    [[nodiscard]] Bounds boundsNow() const { return m_now[1]; }
    [[nodiscard]] Bounds boundsNow(std::size_t cluster) const { return m_now[m_leaves + cluster]; }

    /// As bounds(), of groups of neighbouring clusters, `most` at most (1 or more), which have all of them.
    /// Costs what it returns.
    [[nodiscard]] std::vector<Bounds> boundsOfGroups(std::size_t most) const;

    /// Whether no hit has reached it since its vertices were at their original.
    [[nodiscard]] bool isOriginal(std::size_t cluster) const { return !m_reached[cluster]; }

    /// A point in time, of this object alone: later ones are larger.
    [[nodiscard]] std::uint64_t moment() const { return m_movedFrom + m_moved.size(); }
    /// Boxes that hold all vertices that may have moved since, before and after; nothing: too many to be
    /// remembered, or `moment` is of another object.
    [[nodiscard]] std::optional<std::span<const Bounds>> movedSince(std::uint64_t moment) const;

    // Clusters are lists of indices into clusters(), ascending; what is found is appended.

    /// Finds the clusters that may have a vertex within reachOf(hit), and takes
    /// into account what the hit may do to them. Call once for each hit, in order.
    void advance(const Hit& hit, std::vector<std::uint32_t>& reached);
    /// Likewise, among these clusters only: for taking some through all the hits again.
    void advanceWithin(std::span<const std::uint32_t> among, const Hit& hit,
                       std::vector<std::uint32_t>& reached);
    /// The same for who moves the vertices at once: has to place() each of them before it looks again.
    void find(const Hit& hit, std::vector<std::uint32_t>& reached) const { find(m_now, hit, reached); }
    void findWithin(std::span<const std::uint32_t> among, const Hit& hit,
                    std::vector<std::uint32_t>& reached) const;
    /// Finds the clusters that a hit may reach at whatever time it strikes.
    void everReached(const Hit& hit, std::vector<std::uint32_t>& reached) const;
    /// Likewise any of these, and of `more`: each cluster once. Thousands of hits cost little more than the
    /// clusters that they reach.
    [[nodiscard]] std::vector<std::uint32_t> everReached(std::span<const Hit> hits,
                                                         std::span<const Hit> more = {}) const;
    /// Whether everReached() may find any.
    [[nodiscard]] bool mayEverReach(const Hit& hit) const;

    /// Until the next call: whatever is told to have moved comes out as it was outside of this box. Nothing:
    /// anywhere.
    void limitMoved(const std::optional<Bounds>& within) { m_movedWithin = within; }
    /// All clusters, or these, are back at their original.
    void restart();
    void restart(std::span<const std::uint32_t> clusters);
    /// These are at some earlier state of theirs.
    void goBack(std::span<const std::uint32_t> clusters);
    /// Vertices [first, first + vertices.size()) were as given, and then came the hits `since`. Clusters
    /// given in part keep what they had and grow.
    void place(std::uint32_t first, std::span<const DynamicVertex> vertices, std::span<const Hit> since = {});

    /// All vertices of a cluster are as given.
    void placeCluster(std::uint32_t cluster, std::span<const DynamicVertex> vertices);

    /// The clusters that have a vertex in these ranges (sorted, merged).
    [[nodiscard]] std::vector<std::uint32_t> clustersIn(std::span<const VertexRange> ranges) const;
    /// The vertices of these clusters, sorted and merged.
    [[nodiscard]] std::vector<VertexRange> rangesOf(std::span<const std::uint32_t> clusters) const;

private:
    using Tree = PageCopy<Bounds>;
    [[nodiscard]] Bounds nodeBounds(std::size_t node) const {
        Bounds all = m_now[node];
        all.add(m_ever[node]);
        return all;
    }
    void find(const Tree& tree, const Hit& hit, std::vector<std::uint32_t>& found) const;
    bool addEverReached(const HitReach& hit, std::size_t node, std::vector<bool>& isKnown,
                        std::vector<std::uint32_t>& reached) const;
    void grow(std::uint32_t cluster, const Hit& hit);
    void noteChanged(std::uint32_t cluster);
    void makeOriginal(std::uint32_t cluster);
    void replace(std::uint32_t cluster, const Bounds& box);
    void noteMoved(const Bounds& place);
    void forgetMoved();
    static void refit(Tree& tree, std::size_t leaf);
    static void enlarge(Tree& tree, std::size_t leaf, const Bounds& box);

    std::span<const Cluster> m_clusters;
    std::shared_ptr<const ClusterTree> m_original;  ///< of the boxes
    std::size_t m_leaves = 1;                       ///< of them
    std::vector<bool> m_reached;                    ///< by cluster
    std::vector<std::uint32_t> m_changed;           ///< clusters whose boxes changed since they were made
    std::vector<bool> m_isChanged;                  ///< by cluster: it is in m_changed
    Tree m_now;
    Tree m_ever;  ///< where a box of m_now was before it was drawn tight; with that one, every place
    std::vector<Bounds> m_moved;    ///< in the order in which they did
    std::uint64_t m_movedFrom = 0;  ///< moment() before the first of these
    std::optional<Bounds> m_movedWithin;
};

}  // namespace hitscope
