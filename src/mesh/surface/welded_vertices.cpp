// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/welded_vertices.h"

#include <bit>

namespace hitscope {

namespace {

std::size_t hashOf(const glm::vec3& place) {
    // -0 equals 0, so it must hash alike.
    const auto bits = [](float part) { return std::uint64_t{std::bit_cast<std::uint32_t>(part + 0.0f)}; };
    std::uint64_t hash = bits(place.x) * 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 29 ^ bits(place.y)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 32 ^ bits(place.z)) * 0x94d049bb133111ebu;
    return static_cast<std::size_t>(hash ^ hash >> 31);
}

}  // namespace

std::vector<bool> usedVertices(const MeshData& mesh) {
    std::vector<bool> used(mesh.vertexCount(), false);
    for (const std::uint32_t vertex : mesh.cornerVertices) {
        used[vertex] = true;
    }
    return used;
}

std::vector<std::uint32_t> weldedVertices(const MeshData& mesh) {
    return weldedVertices(mesh.positions, usedVertices(mesh));
}

std::vector<std::uint32_t> weldedVertices(std::span<const glm::vec3> positions,
                                          const std::vector<bool>& used) {
    std::vector<std::uint32_t> standsFor(positions.size());
    // Twice as many places as vertices or more, each empty or the first vertex there; who finds his taken by
    // another place goes on to the next. A map would take ten times the memory.
    const std::size_t mask = std::bit_ceil(2 * positions.size() + 1) - 1;
    std::vector<std::uint32_t> places(mask + 1, kNoIndex);
    for (std::uint32_t v = 0; v < standsFor.size(); ++v) {
        standsFor[v] = v;
        if (used[v]) {
            std::size_t at = hashOf(positions[v]) & mask;
            while (places[at] != kNoIndex && positions[places[at]] != positions[v]) {
                at = (at + 1) & mask;
            }
            if (places[at] == kNoIndex) {
                places[at] = v;
            }
            standsFor[v] = places[at];
        }
    }
    return standsFor;
}

}  // namespace hitscope
