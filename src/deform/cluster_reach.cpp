// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/cluster_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope {
namespace {

// deform() decides and moves in float, the spheres are kept in double: this is what float rounding can add,
// as a part of the numbers involved. Sixteen units in float's last place, where the sums in question lose a
// few.
constexpr double kRounding = 1e-6;

double largestCoordinate(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double slackOf(const glm::dvec3& centre, double radius) {
    return kRounding * (largestCoordinate(centre) + radius);
}

/// How far from `centre` the hit can leave a vertex that it moves: such a vertex ends within maxDistance of
/// the path from the hit point to maxMagnitude along the direction.
double farthestMoved(const glm::dvec3& centre, const Hit& hit) {
    const glm::dvec3 start(hit.point);
    const glm::dvec3 end =
        start + glm::dvec3(hit.direction) * static_cast<double>(hit.constants.maxMagnitude);
    return std::max(glm::distance(centre, start), glm::distance(centre, end)) + hit.constants.maxDistance;
}

}  // namespace

std::vector<VertexRange> merged(std::vector<VertexRange> ranges) {
    std::erase_if(ranges, [](const VertexRange& range) { return range.count == 0; });
    std::sort(ranges.begin(), ranges.end(),
              [](const VertexRange& a, const VertexRange& b) { return a.first < b.first; });
    std::size_t kept = 0;
    for (const VertexRange& range : ranges) {
        if (kept > 0 && range.first <= ranges[kept - 1].first + ranges[kept - 1].count) {
            VertexRange& last = ranges[kept - 1];
            last.count = std::max(last.first + last.count, range.first + range.count) - last.first;
        } else {
            ranges[kept++] = range;
        }
    }
    ranges.resize(kept);
    return ranges;
}

ClusterReach::ClusterReach(std::span<const Cluster> clusters) {
    if (clusters.empty()) {
        return;
    }
    m_nodes.reserve(2 * clusters.size() - 1);
    m_nodes.emplace_back();
    build(clusters, 0);
}

/// Clusters that follow each other are neighbours in space, so halving the run gives a good tree.
void ClusterReach::build(std::span<const Cluster> clusters, std::size_t node) {
    if (clusters.size() == 1) {
        Node& leaf = m_nodes[node];
        const Sphere& bounds = clusters.front().bounds;
        leaf.centre = glm::dvec3(bounds.centre);
        leaf.radius = bounds.radius + slackOf(leaf.centre, bounds.radius);
        leaf.range = {clusters.front().first, clusters.front().count};
        return;
    }
    const std::size_t firstChild = m_nodes.size();
    m_nodes.resize(firstChild + 2);
    const std::size_t half = clusters.size() / 2;
    build(clusters.first(half), firstChild);
    build(clusters.subspan(half), firstChild + 1);

    Node& inner = m_nodes[node];
    inner.firstChild = static_cast<std::uint32_t>(firstChild);
    inner.centre = 0.5 * (m_nodes[firstChild].centre + m_nodes[firstChild + 1].centre);
    encloseChildren(inner);
}

void ClusterReach::encloseChildren(Node& node) const {
    for (const std::size_t i : {node.firstChild, node.firstChild + 1}) {
        const Node& child = m_nodes[i];
        node.radius = std::max(node.radius, glm::distance(node.centre, child.centre) + child.radius);
    }
}

std::vector<VertexRange> ClusterReach::advance(const Hit& hit) {
    std::vector<VertexRange> found;
    if (!m_nodes.empty()) {
        visit(0, hit, found);
    }
    return merged(std::move(found));
}

void ClusterReach::visit(std::size_t index, const Hit& hit, std::vector<VertexRange>& found) {
    Node& node = m_nodes[index];
    const double distance = glm::distance(node.centre, glm::dvec3(hit.point));
    const double reach = node.radius + hit.constants.maxDistance;
    if (distance > reach + kRounding * reach) {
        return;
    }
    if (node.firstChild == 0) {
        found.push_back(node.range);
        const double pushed =
            std::min(node.radius + hit.constants.maxMagnitude, farthestMoved(node.centre, hit));
        node.radius = std::max(node.radius, pushed + slackOf(node.centre, pushed));
        return;
    }
    visit(node.firstChild, hit, found);
    visit(node.firstChild + 1, hit, found);
    encloseChildren(node);
}

}  // namespace hitscope
