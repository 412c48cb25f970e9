// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/sewn_vertices.h"

#include <algorithm>
#include <tuple>

#include "mesh/surface/disjoint_sets.h"
#include "mesh/surface/welded_vertices.h"

namespace hitscope {

namespace {

/// One of a triangle, with its ends in the order of their places.
struct SplitEdge {
    std::uint32_t lowPlace = 0;
    std::uint32_t highPlace = 0;
    std::uint32_t low = 0;  ///< file vertices
    std::uint32_t high = 0;

    [[nodiscard]] auto key() const { return std::tie(lowPlace, highPlace, low, high); }
    [[nodiscard]] bool isAtSamePlace(const SplitEdge& other) const {
        return lowPlace == other.lowPlace && highPlace == other.highPlace;
    }
    [[nodiscard]] bool isSame(const SplitEdge& other) const { return key() == other.key(); }
};

/// Those whose ends both are at a place of several vertices; sorted.
std::vector<SplitEdge> splitEdges(std::span<const std::uint32_t> places,
                                  std::span<const std::uint32_t> triangles) {
    std::vector<bool> isSplit(places.size(), false);
    for (std::uint32_t v = 0; v < places.size(); ++v) {
        isSplit[places[v]] = isSplit[places[v]] || places[v] != v;
    }
    std::vector<SplitEdge> edges;
    for (std::size_t first = 0; first + 2 < triangles.size(); first += 3) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = triangles[first + corner];
            const std::uint32_t b = triangles[first + (corner + 1) % 3];
            const std::uint32_t placeA = places[a];
            const std::uint32_t placeB = places[b];
            if (placeA != placeB && isSplit[placeA] && isSplit[placeB]) {
                edges.push_back(placeA < placeB ? SplitEdge{placeA, placeB, a, b}
                                                : SplitEdge{placeB, placeA, b, a});
            }
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const SplitEdge& a, const SplitEdge& b) { return a.key() < b.key(); });
    return edges;
}

/// Of edges at one place, sorted: those that a single triangle has.
std::vector<SplitEdge> borders(std::span<const SplitEdge> edges) {
    std::vector<SplitEdge> found;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool isLikeLast = i > 0 && edges[i].isSame(edges[i - 1]);
        const bool isLikeNext = i + 1 < edges.size() && edges[i].isSame(edges[i + 1]);
        if (!isLikeLast && !isLikeNext) {
            found.push_back(edges[i]);
        }
    }
    return found;
}

}  // namespace

std::vector<std::uint32_t> sewnVertices(std::span<const glm::vec3> positions,
                                        std::span<const std::uint32_t> triangles) {
    std::vector<bool> used(positions.size(), false);
    for (const std::uint32_t vertex : triangles) {
        used[vertex] = true;
    }
    const std::vector<SplitEdge> edges = splitEdges(weldedVertices(positions, used), triangles);
    if (edges.empty()) {
        return {};
    }
    DisjointSets sets(positions.size());
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        while (end < edges.size() && edges[end].isAtSamePlace(edges[first])) {
            ++end;
        }
        const std::vector<SplitEdge> ending = borders(std::span(edges).subspan(first, end - first));
        if (ending.size() == 2) {
            sets.join(ending[0].low, ending[1].low);
            sets.join(ending[0].high, ending[1].high);
        }
    }
    if (sets.sets() == positions.size()) {
        return {};
    }
    std::vector<std::uint32_t> sewn(positions.size());
    for (std::uint32_t v = 0; v < sewn.size(); ++v) {
        sewn[v] = sets.find(v).root;
    }
    return sewn;
}

}  // namespace hitscope
