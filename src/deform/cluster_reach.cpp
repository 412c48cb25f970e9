// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/cluster_reach.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <utility>

#include "deform/dent_shape.h"
#include "deform/hit_bounds.h"

namespace hitscope {
namespace {

constexpr std::size_t kMostMoved = 4096;  // boxes that are remembered; at least the last half of so many
// One cluster in so many: where fewer changed, their boxes are put back one by one. New trees would copy each
// page (PageCopy) again as the next hits change it, which takes longer than such a hit.
constexpr std::size_t kFew = 8;

/// A moment after all of any object so far.
std::uint64_t newMoments() {
    constexpr std::uint64_t kApart = std::uint64_t{1} << 36U;  // no object has as many between two calls
    static std::atomic<std::uint64_t> next{0};
    return next.fetch_add(kApart, std::memory_order_relaxed) + 1;
}

Bounds around(std::span<const DynamicVertex> vertices) {
    Bounds box;
    for (const DynamicVertex& vertex : vertices) {
        box.add(vertex.position);
    }
    return box;
}

bool holds(const Bounds& box, const Bounds& other) {
    return glm::all(glm::lessThanEqual(box.min, other.min)) &&
           glm::all(glm::greaterThanEqual(box.max, other.max));
}

/// Empty: there is nothing that both hold.
Bounds common(const Bounds& a, const Bounds& b) {
    const Bounds both{glm::max(a.min, b.min), glm::min(a.max, b.max)};
    return glm::any(glm::greaterThan(both.min, both.max)) ? Bounds{} : both;
}

bool isSame(const Bounds& a, const Bounds& b) {
    return a.min == b.min && a.max == b.max;
}

}  // namespace

ClusterReach::ClusterReach(std::span<const Cluster> clusters, std::shared_ptr<const ClusterTree> tree)
    : m_clusters(clusters),
      m_original(tree ? std::move(tree) : clusterTreeOf(clusters)),
      m_leaves(m_original->size() / 2) {
    restart();
}

std::vector<Bounds> ClusterReach::boundsOfGroups(std::size_t most) const {
    const std::size_t count = std::min(std::bit_floor(most), m_leaves);
    std::vector<Bounds> bounds(count);
    for (std::size_t i = 0; i < count; ++i) {
        bounds[i] = nodeBounds(count + i);
    }
    return bounds;
}

void ClusterReach::restart() {
    if (m_now.size() > 0 && m_changed.size() < m_clusters.size() / kFew) {
        restart(m_changed);
        for (const std::uint32_t cluster : m_changed) {
            m_isChanged[cluster] = false;
        }
    } else {
        m_now = Tree(*m_original);
        m_ever = Tree(*m_original);
        m_reached.assign(m_clusters.size(), false);
        m_isChanged.assign(m_clusters.size(), false);
        forgetMoved();
    }
    m_changed.clear();
}

void ClusterReach::noteChanged(std::uint32_t cluster) {
    if (!m_isChanged[cluster]) {
        m_isChanged[cluster] = true;
        m_changed.push_back(cluster);
    }
}

void ClusterReach::makeOriginal(std::uint32_t cluster) {
    const std::size_t leaf = m_leaves + cluster;
    m_now[leaf] = m_clusters[cluster].bounds;
    m_ever[leaf] = m_clusters[cluster].bounds;
    m_reached[cluster] = false;
    refit(m_now, leaf);
    refit(m_ever, leaf);
}

void ClusterReach::forgetMoved() {
    m_moved.clear();
    m_movedFrom = newMoments();
}

void ClusterReach::noteMoved(const Bounds& place) {
    const Bounds box = m_movedWithin ? common(place, *m_movedWithin) : place;
    if (box.empty()) {
        return;
    }
    if (m_moved.size() == kMostMoved) {
        m_moved.erase(m_moved.begin(), m_moved.begin() + kMostMoved / 2);
        m_movedFrom += kMostMoved / 2;
    }
    m_moved.push_back(box);
}

std::optional<std::span<const Bounds>> ClusterReach::movedSince(std::uint64_t moment) const {
    if (moment < m_movedFrom || moment > this->moment()) {
        return std::nullopt;
    }
    return std::span(m_moved).subspan(moment - m_movedFrom);
}

/// Makes a leaf's ancestors hold their children again.
void ClusterReach::refit(Tree& tree, std::size_t leaf) {
    for (std::size_t node = leaf / 2; node > 0; node /= 2) {
        Bounds box = tree[2 * node];
        box.add(tree[2 * node + 1]);
        if (isSame(box, tree[node])) {
            return;
        }
        tree[node] = box;
    }
}

/// Adds to a leaf, and to those of its ancestors that do not hold `box` yet.
void ClusterReach::enlarge(Tree& tree, std::size_t leaf, const Bounds& box) {
    for (std::size_t node = leaf; node > 0 && !holds(tree[node], box); node /= 2) {
        tree[node].add(box);
    }
}

/// Puts a box in the place of one that the vertices may have been in.
void ClusterReach::replace(std::uint32_t cluster, const Bounds& box) {
    const std::size_t leaf = m_leaves + cluster;
    noteChanged(cluster);
    enlarge(m_ever, leaf, m_now[leaf]);
    m_now[leaf] = box;
    refit(m_now, leaf);
}

/// Depth first, left to right, so that what is found is sorted.
void ClusterReach::find(const Tree& tree, const Hit& hit, std::vector<std::uint32_t>& found) const {
    std::array<std::size_t, 64> stack{};  // a level has one node waiting at most, and levels are 32
    std::size_t waiting = 0;
    const HitReach sphere = reachOf(hit);
    const float reach = withRounding(sphere.radius);
    const float reachSquared = reach * reach;
    std::size_t node = 1;
    for (;;) {
        if (distanceSquared(tree[node], sphere.centre) <= reachSquared) {
            if (node < m_leaves) {
                stack[waiting++] = 2 * node + 1;
                node = 2 * node;
                continue;
            }
            found.push_back(static_cast<std::uint32_t>(node - m_leaves));
        }
        if (waiting == 0) {
            return;
        }
        node = stack[--waiting];
    }
}

void ClusterReach::grow(std::uint32_t cluster, const Hit& hit) {
    m_reached[cluster] = true;
    noteChanged(cluster);
    const std::size_t leaf = m_leaves + cluster;
    const Bounds moved = movedBy(m_now[leaf], hit);
    enlarge(m_now, leaf, moved);
    noteMoved(moved);
}

void ClusterReach::advance(const Hit& hit, std::vector<std::uint32_t>& reached) {
    const std::size_t before = reached.size();
    find(m_now, hit, reached);
    for (std::size_t i = before; i < reached.size(); ++i) {
        grow(reached[i], hit);
    }
}

void ClusterReach::advanceWithin(std::span<const std::uint32_t> among, const Hit& hit,
                                 std::vector<std::uint32_t>& reached) {
    const HitReach sphere = reachOf(hit);
    for (const std::uint32_t cluster : among) {
        if (reaches(sphere, m_now[m_leaves + cluster])) {
            reached.push_back(cluster);
            grow(cluster, hit);
        }
    }
}

void ClusterReach::findWithin(std::span<const std::uint32_t> among, const Hit& hit,
                              std::vector<std::uint32_t>& reached) const {
    const HitReach sphere = reachOf(hit);
    std::copy_if(among.begin(), among.end(), std::back_inserter(reached),
                 [&](std::uint32_t cluster) { return reaches(sphere, m_now[m_leaves + cluster]); });
}

void ClusterReach::everReached(const Hit& hit, std::vector<std::uint32_t>& reached) const {
    std::vector<std::uint32_t> before;
    std::vector<std::uint32_t> now;
    find(m_ever, hit, before);
    find(m_now, hit, now);
    std::set_union(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(reached));
}

std::vector<std::uint32_t> ClusterReach::everReached(std::span<const Hit> hits,
                                                     std::span<const Hit> more) const {
    std::vector<bool> isKnown(2 * m_leaves, false);  // by node: all clusters below are found
    std::vector<std::uint32_t> reached;
    for (const std::span<const Hit> some : {hits, more}) {
        for (const Hit& hit : some) {
            addEverReached(reachOf(hit), 1, isKnown, reached);
        }
    }
    std::sort(reached.begin(), reached.end());
    return reached;
}

/// Returns whether all clusters below the node are found.
bool ClusterReach::addEverReached(const HitReach& hit, std::size_t node, std::vector<bool>& isKnown,
                                  std::vector<std::uint32_t>& reached) const {
    if (isKnown[node] || (!reaches(hit, m_ever[node]) && !reaches(hit, m_now[node]))) {
        return isKnown[node];
    }
    if (node >= m_leaves) {
        isKnown[node] = true;
        reached.push_back(static_cast<std::uint32_t>(node - m_leaves));
    } else {
        const bool isLeft = addEverReached(hit, 2 * node, isKnown, reached);
        const bool isRight = addEverReached(hit, 2 * node + 1, isKnown, reached);
        isKnown[node] = isLeft && isRight;
    }
    return isKnown[node];
}

bool ClusterReach::mayEverReach(const Hit& hit) const {
    const HitReach sphere = reachOf(hit);
    return reaches(sphere, m_ever[1]) || reaches(sphere, m_now[1]);
}

void ClusterReach::restart(std::span<const std::uint32_t> clusters) {
    for (const std::uint32_t cluster : clusters) {
        noteMoved(nodeBounds(m_leaves + cluster));  // where they were first is in m_ever
        makeOriginal(cluster);
    }
}

void ClusterReach::goBack(std::span<const std::uint32_t> clusters) {
    for (const std::uint32_t cluster : clusters) {
        const std::size_t leaf = m_leaves + cluster;
        enlarge(m_now, leaf, m_ever[leaf]);
        noteMoved(nodeBounds(leaf));
    }
}

void ClusterReach::place(std::uint32_t first, std::span<const DynamicVertex> vertices,
                         std::span<const Hit> since) {
    const auto end = first + static_cast<std::uint32_t>(vertices.size());
    const VertexRange range{first, end - first};
    for (const std::uint32_t index : clustersIn({&range, 1})) {
        m_reached[index] = true;
        const Cluster& cluster = m_clusters[index];
        const std::uint32_t begin = std::max(cluster.first, first);
        const std::uint32_t count = std::min(cluster.first + cluster.count, end) - begin;
        Bounds box = around(vertices.subspan(begin - first, count));
        for (const Hit& hit : since) {
            if (reaches(reachOf(hit), box)) {
                box.add(movedBy(box, hit));
            }
        }
        if (count < cluster.count) {
            box.add(m_now[m_leaves + index]);
        }
        replace(index, box);
    }
}

void ClusterReach::placeCluster(std::uint32_t cluster, std::span<const DynamicVertex> vertices) {
    replace(cluster, around(vertices));
    noteMoved(nodeBounds(m_leaves + cluster));
}

std::vector<std::uint32_t> ClusterReach::clustersIn(std::span<const VertexRange> ranges) const {
    std::vector<std::uint32_t> found;
    for (const VertexRange& range : ranges) {
        auto cluster = std::partition_point(m_clusters.begin(), m_clusters.end(), [&range](const Cluster& c) {
            return c.first + c.count <= range.first;
        });
        for (; cluster != m_clusters.end() && cluster->first < range.first + range.count; ++cluster) {
            const auto index = static_cast<std::uint32_t>(cluster - m_clusters.begin());
            if (found.empty() || found.back() != index) {
                found.push_back(index);
            }
        }
    }
    return found;
}

std::vector<VertexRange> ClusterReach::rangesOf(std::span<const std::uint32_t> clusters) const {
    std::vector<VertexRange> ranges;
    ranges.reserve(clusters.size());
    for (const std::uint32_t index : clusters) {
        const Cluster& cluster = m_clusters[index];
        if (!ranges.empty() && ranges.back().first + ranges.back().count == cluster.first) {
            ranges.back().count += cluster.count;
        } else {
            ranges.push_back({cluster.first, cluster.count});
        }
    }
    return ranges;
}

}  // namespace hitscope
