// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/zero_array.h"
#include "deform/cluster_reach.h"
#include "deform/hits_by_target.h"
#include "deform/vertex_copy.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// What one hit did to its target, in the state that the hits before it had left.
struct HitEffect {
    std::uint32_t affected = 0;        ///< file vertices that it moved
    float greatest = 0.0f;             ///< metres: the longest way it moved one
    std::uint32_t deepest = kNoIndex;  ///< the file vertex it moved that far, the lowest of several;
                                       ///< kNoIndex: it moved none

    bool operator==(const HitEffect&) const = default;
};

/// What each hit on one target did, and how many hits moved each vertex, by the reference deformation.
///
/// Follows edits at the cost of what they reach: hits at the end are applied to the clusters they reach, any
/// other change takes the clusters concerned from their originals through all hits again. For that it notes
/// what each hit did to each cluster; where that grows beyond kMostParts it is dropped, and such changes
/// start over.
class TargetEffects {
public:
    /// No hit has been made yet.
    explicit TargetEffects(std::shared_ptr<const RenderMesh> mesh);

    /// What follow() changed.
    struct Changes {
        std::vector<std::uint32_t> hits;      ///< indices into effects(), ascending
        std::vector<std::uint32_t> vertices;  ///< file vertices whose counts() may differ
    };
    /// Follows edits of the target's hits, in the order made, after which they are `hits`. When `stop` is set
    /// meanwhile it returns early, and this is of no use any more.
    Changes follow(std::span<const TargetHitsEdit> edits, std::span<const Hit> hits,
                   const std::atomic<bool>& stop);

    [[nodiscard]] std::span<const HitEffect> effects() const { return m_effects; }  ///< one a hit
    /// How many hits moved each vertex; one a file vertex.
    [[nodiscard]] std::span<const std::uint32_t> counts() const { return m_counts.all(); }
    /// After all hits; one a render vertex.
    [[nodiscard]] std::span<const DynamicVertex> vertices() const { return m_vertices.all(); }
    /// The file vertices that hits[index] moved, ascending; `hits` are those followed.
    [[nodiscard]] std::vector<std::uint32_t> movedBy(std::size_t index, std::span<const Hit> hits) const;

    /// 64 MB.
    static constexpr std::size_t kMostParts = std::size_t{4} << 20;

private:
    /// What a hit did to the vertices of one cluster.
    struct Part {
        std::uint32_t cluster = 0;
        HitEffect effect;
    };
    [[nodiscard]] bool isFirstOf(std::uint32_t renderVertex) const;
    void startOver(std::span<const Hit> hits, const std::atomic<bool>& stop, Changes& changes);
    void append(std::size_t first, std::span<const Hit> hits, const std::atomic<bool>& stop,
                Changes& changes);
    void redo(std::span<const std::uint32_t> concerned, std::span<const Hit> hits,
              const std::atomic<bool>& stop, Changes& changes);
    [[nodiscard]] std::vector<std::uint32_t> concernedBy(std::span<const TargetHitsEdit> edits) const;
    void splice(const TargetHitsEdit& edit);
    HitEffect apply(const Hit& hit, std::uint32_t cluster);
    void applyTo(std::span<const std::uint32_t> clusters, const Hit& hit, std::size_t index);
    void restore(std::uint32_t cluster);
    void forgetParts();
    void addVertices(std::span<const std::uint32_t> clusters, Changes& changes) const;

    std::shared_ptr<const RenderMesh> m_mesh;
    mutable VertexCopy m_vertices;  ///< of the clusters that hits have reached, unless all are asked for
    ClusterReach m_reach;
    ZeroArray<std::uint32_t> m_counts;
    std::vector<HitEffect> m_effects;
    std::vector<std::vector<Part>> m_parts;  ///< one a hit: the clusters where it moved some; or empty
    std::size_t m_partCount = 0;
    bool m_keepsParts = true;
};

}  // namespace hitscope
