// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "deform/dent_shape.h"
#include "deform/hit.h"
#include "deform/vertex_range.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// A hit's DentShape as the shaders of hits.glsl and deform.comp read it from a buffer: three vec4.
struct PackedHit {
    glm::vec3 point;
    float maxDistance;
    glm::vec3 direction;
    float power;
    float maxMagnitude;
    float code;  ///< formCode(); the curve's place is that of a record, from the batch's first
    float unused[2];
};
static_assert(sizeof(PackedHit) == 48);

/// What tells deformBy() of dent_forms.glsl the form of a hit: exact in a float for places below two million.
[[nodiscard]] constexpr float formCode(DentKind kind, std::size_t curve) {
    constexpr std::size_t kKinds = 8;
    return static_cast<float>(static_cast<std::size_t>(kind) + kKinds * curve);
}

/// A cluster and the hits of a batch that may reach it: entries [firstIndex, firstIndex + indexCount) of the
/// batch's list of hits, in the order they strike. A uvec4 to the shaders.
struct ClusterHits {
    std::uint32_t firstVertex = 0;
    std::uint32_t vertexCount = 0;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
};
static_assert(sizeof(ClusterHits) == 16);

/// Hits on one target that are applied in one pass. A vertex meets only the hits that may reach its cluster;
/// order matters only within a vertex, so clusters may be done in any order and side by side.
class HitBatch {
public:
    /// `clusters` outlive this.
    explicit HitBatch(std::span<const Cluster> clusters)
        : m_clusters(clusters), m_slotOf(clusters.size(), kNoIndex) {}

    static constexpr std::size_t kMostIndices = 65536;
    static constexpr std::size_t kMostHits = 4096;  ///< records(), but for a curve of the last

    /// Whether add() may be called for one more hit that may reach that many clusters. Empty batches have
    /// room.
    [[nodiscard]] bool hasRoom(std::size_t reached) const;
    /// The next hit and the clusters it may reach. A hit that reaches none is left out.
    void add(const Hit& hit, std::span<const std::uint32_t> reached);
    [[nodiscard]] bool empty() const { return m_hits.empty(); }
    void clear();

    /// Sorts the hits by cluster: call when all are added, and before reading the rest.
    void finish();
    [[nodiscard]] std::span<const DentShape> hits() const { return m_hits; }
    /// As the shaders read them: a record a hit, and behind them two for each curve.
    [[nodiscard]] std::span<const PackedHit> records() const { return m_records; }
    [[nodiscard]] std::span<const std::uint32_t> indices() const { return m_indices; }  ///< into hits()
    /// The clusters reached: first paperClusters(), then formClusters().
    [[nodiscard]] std::span<const ClusterHits> clusters() const { return m_work; }
    /// Those that only hits of the paper's function may reach, ascending. A software renderer takes twice as
    /// long where other forms are possible.
    [[nodiscard]] std::span<const ClusterHits> paperClusters() const {
        return clusters().first(m_paperClusters);
    }
    /// The others, ascending.
    [[nodiscard]] std::span<const ClusterHits> formClusters() const {
        return clusters().subspan(m_paperClusters);
    }
    /// All vertices of the clusters reached, sorted and merged.
    [[nodiscard]] std::vector<VertexRange> ranges() const;

private:
    struct Reach {
        std::uint32_t slot;
        std::uint32_t hit;
    };
    void pack();
    [[nodiscard]] std::vector<std::uint32_t> sortedClusters();
    void addWork(std::uint32_t cluster, std::span<const std::uint32_t> hits);

    std::span<const Cluster> m_clusters;
    std::vector<DentShape> m_hits;
    std::size_t m_curves = 0;  ///< of m_hits
    std::vector<PackedHit> m_records;
    std::vector<std::uint32_t> m_slotOf;   ///< cluster -> its place in m_reached, or kNoIndex
    std::vector<std::uint32_t> m_reached;  ///< clusters, in the order in which they were first reached
    std::vector<std::uint32_t> m_counts;   ///< slot -> hits
    std::vector<bool> m_slotHasForms;      ///< slot -> whether one of them has another form than the paper's
    std::vector<Reach> m_reaches;          ///< as added: in the order of the hits
    std::vector<std::uint32_t> m_indices;
    std::vector<ClusterHits> m_work;
    std::size_t m_paperClusters = 0;  ///< of m_work
};

}  // namespace hitscope
