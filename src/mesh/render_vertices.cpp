// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/render_vertices.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/give_up.h"
#include "core/parallel.h"
#include "core/raw_vector.h"
#include "mesh/spatial_order.h"

namespace hitscope {
namespace {

// Fewer are done sooner than a thread is started.
constexpr std::size_t kSeedsAThread = 8192;
constexpr std::size_t kClustersAThread = 256;

/// std::sort() keeps so many equal ones in their order.
constexpr std::size_t kMostKeptInOrder = 16;

/// What a render vertex is made of.
struct Seed {
    glm::vec3 normal{0.0f};
    std::uint32_t fileVertex = 0;
    std::uint32_t corner = kNoIndex;  ///< the first that it is of; none: no face uses the vertex
};

glm::vec2 texcoordOf(const MeshData& mesh, std::uint32_t corner) {
    const bool hasOne = !mesh.cornerTexcoords.empty() && corner != kNoIndex;
    const std::uint32_t index = hasOne ? mesh.cornerTexcoords[corner] : kNoIndex;
    const glm::vec2 texcoord = index == kNoIndex ? glm::vec2(0.0f) : mesh.texcoords[index];
    return std::isfinite(texcoord.x) && std::isfinite(texcoord.y) ? texcoord : glm::vec2(0.0f);
}

/// What makes a corner of a vertex a render vertex of its own.
using SeedKey = std::tuple<float, float, float, float, float>;

SeedKey seedKey(const MeshData& mesh, const glm::vec3& normal, std::uint32_t corner) {
    const glm::vec2 texcoord = texcoordOf(mesh, corner);
    return {normal.x, normal.y, normal.z, texcoord.x, texcoord.y};
}

/// Those of all vertices, in the file's order, and then of those that no face uses. Made in parts, of
/// neighbouring vertices each.
class Seeds {
public:
    /// Fills `numbers`: for each corner the number of its seed, within its part.
    Seeds(const MeshData& mesh, const VertexCorners& vertexCorners, const CornerNormals& normals,
          std::span<std::uint32_t> numbers)
        : m_mesh(mesh),
          m_vertexCorners(vertexCorners),
          m_parts(std::clamp<std::size_t>(mesh.vertexCount() / kSeedsAThread, 1, usefulThreads())),
          m_seeds(m_parts + 1),
          m_starts(m_parts + 2, 0) {
        std::vector<std::vector<Seed>> unused(m_parts);
        forEachAtOnce(m_parts, [&](std::size_t part) { make(part, normals, numbers, unused[part]); });
        for (const std::vector<Seed>& some : unused) {
            m_seeds.back().insert(m_seeds.back().end(), some.begin(), some.end());
        }
        for (std::size_t part = 0; part <= m_parts; ++part) {
            m_starts[part + 1] = m_starts[part] + static_cast<std::uint32_t>(m_seeds[part].size());
        }
    }

    [[nodiscard]] std::size_t size() const { return m_starts.back(); }
    [[nodiscard]] std::size_t used() const { return m_starts[m_parts]; }
    [[nodiscard]] const Seed& operator[](std::size_t seed) const {
        std::size_t part = 0;
        while (seed >= m_starts[part + 1]) {
            ++part;
        }
        return m_seeds[part][seed - m_starts[part]];
    }
    /// The numbers of seeds within their parts become those of render vertices.
    void renumber(std::span<std::uint32_t> numbers, std::span<const std::uint32_t> renderVertices) const {
        forEachAtOnce(m_parts, [&](std::size_t part) {
            const std::span<const std::uint32_t> ofPart = renderVertices.subspan(m_starts[part]);
            for (std::size_t v = firstOf(part); v < firstOf(part + 1); ++v) {
                mayGiveUp(v);
                for (const std::uint32_t corner : m_vertexCorners.of(v)) {
                    numbers[corner] = ofPart[numbers[corner]];
                }
            }
        });
    }

private:
    [[nodiscard]] std::size_t firstOf(std::size_t part) const {
        return m_mesh.vertexCount() * part / m_parts;
    }

    void make(std::size_t part, const CornerNormals& normals, std::span<std::uint32_t> numbers,
              std::vector<Seed>& unused) {
        std::vector<Seed>& seeds = m_seeds[part];
        seeds.reserve(firstOf(part + 1) - firstOf(part));
        CornerNormals::Reader reader(normals);
        std::vector<std::pair<SeedKey, std::uint32_t>> sorted;
        for (std::size_t v = firstOf(part); v < firstOf(part + 1); ++v) {
            mayGiveUp(v);
            const auto fileVertex = static_cast<std::uint32_t>(v);
            const std::span<const std::uint32_t> corners = m_vertexCorners.of(v);
            if (corners.empty()) {
                unused.push_back({glm::vec3(0.0f), fileVertex, kNoIndex});
            }
            const std::span<const glm::vec3> normalsOf = reader.of(v);
            sorted.clear();
            bool isOne = true;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                sorted.emplace_back(seedKey(m_mesh, normalsOf[i], corners[i]), corners[i]);
                isOne = isOne && sorted.back().first == sorted.front().first;
            }
            if (!isOne || sorted.size() > kMostKeptInOrder) {
                std::sort(sorted.begin(), sorted.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; });
            }
            for (std::size_t i = 0; i < sorted.size(); ++i) {
                const auto& [key, corner] = sorted[i];
                if (i == 0 || key != sorted[i - 1].first) {
                    const glm::vec3 normal(std::get<0>(key), std::get<1>(key), std::get<2>(key));
                    seeds.push_back({normal, fileVertex, corner});
                }
                numbers[corner] = static_cast<std::uint32_t>(seeds.size() - 1);
            }
        }
    }

    const MeshData& m_mesh;
    const VertexCorners& m_vertexCorners;
    std::size_t m_parts;
    std::vector<std::vector<Seed>> m_seeds;  ///< a part's; and of the vertices that no face uses
    std::vector<std::uint32_t> m_starts;     ///< of each, and their end
};

/// Those that faces use by place, and then the others by place.
RawVector<PlacedItem> orderOfSeeds(const MeshData& mesh, const Seeds& seeds) {
    RawVector<PlacedItem> points(seeds.size());
    inWatchedParts(points.size(), kSeedsAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            points[i] = {mesh.positions[seeds[i].fileVertex], static_cast<std::uint32_t>(i)};
        }
    });
    orderBySpace(std::span(points).first(seeds.used()));
    orderBySpace(std::span(points).subspan(seeds.used()));
    return points;
}

std::vector<Cluster> clustersOf(std::span<const DynamicVertex> vertices) {
    std::vector<Cluster> clusters((vertices.size() + kClusterVertices - 1) / kClusterVertices);
    inWatchedParts(clusters.size(), kClustersAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto first = static_cast<std::uint32_t>(i * kClusterVertices);
            clusters[i].first = first;
            clusters[i].count =
                std::min(kClusterVertices, static_cast<std::uint32_t>(vertices.size()) - first);
            for (const DynamicVertex& vertex : vertices.subspan(first, clusters[i].count)) {
                clusters[i].bounds.add(vertex.position);
            }
        }
    });
    return clusters;
}

}  // namespace

void makeRenderVertices(const MeshData& mesh, const VertexCorners& vertexCorners,
                        const CornerNormals& normals, RenderMesh& render) {
    render.cornerRenderVertices.resize(mesh.cornerVertices.size());
    const Seeds seeds(mesh, vertexCorners, normals, render.cornerRenderVertices);
    render.drawnVertices = static_cast<std::uint32_t>(seeds.used());
    const RawVector<PlacedItem> order = orderOfSeeds(mesh, seeds);
    render.vertices.resize(order.size());
    render.texcoords.resize(order.size());
    render.fileVertices.resize(order.size());
    RawVector<std::uint32_t> placeOf(order.size());
    inWatchedParts(order.size(), kSeedsAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Seed& seed = seeds[order[i].index];
            render.vertices[i] = {mesh.positions[seed.fileVertex], seed.normal};
            render.texcoords[i] = texcoordOf(mesh, seed.corner);
            render.fileVertices[i] = seed.fileVertex;
            placeOf[order[i].index] = static_cast<std::uint32_t>(i);
        }
    });
    seeds.renumber(render.cornerRenderVertices, placeOf);
    for (const DynamicVertex& vertex : std::span(render.vertices).first(render.drawnVertices)) {
        render.bounds.add(vertex.position);
    }
    render.clusters = clustersOf(render.vertices);
    render.clusterTree = clusterTreeOf(render.clusters);
}

}  // namespace hitscope
