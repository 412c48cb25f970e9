// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/random_hits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "deform/cluster_reach.h"
#include "deform/deform.h"

namespace hitscope::bench {

namespace {

constexpr float kSpread = 0.5773503f;  // tan 30 degrees

std::array<glm::vec3, 3> corners(const RenderMesh& mesh, std::size_t triangle) {
    const auto at = [&](std::size_t corner) {
        return mesh.vertices[mesh.triangles[3 * triangle + corner]].position;
    };
    return {at(0), at(1), at(2)};
}

float doubleArea(const std::array<glm::vec3, 3>& triangle) {
    return glm::length(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
}

float largestDoubleArea(const RenderMesh& mesh) {
    float largest = 0.0f;
    for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
        largest = std::max(largest, doubleArea(corners(mesh, t)));
    }
    return largest;
}

}  // namespace

RandomHits::RandomHits(const std::vector<HitTarget>& targets, const DeformationConstants& constants,
                       std::uint32_t seed)
    : m_constants(constants), m_random(seed) {
    for (const HitTarget& target : targets) {
        m_surfaces.push_back({target, largestDoubleArea(*target.mesh)});
    }
}

/// In [0, 1); the standard's distributions differ between machines.
float RandomHits::unit() {
    return static_cast<float>(m_random() >> 8) * (1.0f / 16777216.0f);
}

std::size_t RandomHits::pickTriangle(const Surface& surface) {
    const RenderMesh& mesh = *surface.target.mesh;
    const std::size_t triangles = mesh.triangles.size() / 3;
    std::size_t triangle = 0;
    do {
        triangle = m_random() % triangles;
    } while (doubleArea(corners(mesh, triangle)) < unit() * surface.largestArea);
    return triangle;
}

Hit RandomHits::next() {
    const Surface& surface = m_surfaces[m_turn++ % m_surfaces.size()];
    const std::array<glm::vec3, 3> at = corners(*surface.target.mesh, pickTriangle(surface));
    float u = unit();
    float v = unit();
    if (u + v > 1.0f) {
        u = 1.0f - u;
        v = 1.0f - v;
    }
    Hit hit;
    hit.target = surface.target.id;
    hit.constants = m_constants;
    hit.point = at[0] + u * (at[1] - at[0]) + v * (at[2] - at[0]);
    const glm::vec3 inwards = -glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
    glm::vec3 aside{1.0f};
    while (glm::dot(aside, aside) > 1.0f) {
        aside = {2.0f * unit() - 1.0f, 2.0f * unit() - 1.0f, 2.0f * unit() - 1.0f};
    }
    hit.direction = glm::normalize(inwards + kSpread * (aside - glm::dot(aside, inwards) * inwards));
    return hit;
}

std::vector<Hit> RandomHits::next(std::size_t count) {
    std::vector<Hit> hits;
    hits.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        hits.push_back(next());
    }
    return hits;
}

// A disc of radius r cuts r^2 / (4 radius^2) out of the sphere's surface. Smaller by a factor s is: lengths
// by s, and power, an area, by s^2.
DeformationConstants constantsReaching(double affected, double vertices, double radius) {
    const DeformationConstants paper;
    const double reach = 2.0 * radius * std::sqrt(affected / vertices);
    const double scale = reach / static_cast<double>(paper.maxDistance);
    DeformationConstants constants;
    constants.maxDistance = static_cast<float>(reach);
    constants.power = static_cast<float>(scale * scale * static_cast<double>(paper.power));
    constants.maxMagnitude = static_cast<float>(scale * static_cast<double>(paper.maxMagnitude));
    return constants;
}

double countAffected(const RenderMesh& mesh, const std::vector<Hit>& hits) {
    PageVector<DynamicVertex> vertices = mesh.vertices;
    ClusterReach reach(mesh);
    std::size_t affected = 0;
    std::vector<std::uint32_t> reached;
    for (const Hit& hit : hits) {
        reached.clear();
        reach.advance(hit, reached);
        for (const VertexRange& range : reach.rangesOf(reached)) {
            for (DynamicVertex& vertex : std::span(vertices).subspan(range.first, range.count)) {
                affected += deform(vertex.position, vertex.normal, hit) ? 1 : 0;
            }
        }
    }
    return hits.empty() ? 0.0 : static_cast<double>(affected) / static_cast<double>(hits.size());
}

}  // namespace hitscope::bench
