// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/time_limit.h"
#include "deform/cluster_reach.h"
#include "deform/hits_by_target.h"
#include "deform/vertex_copy.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// The paper's Algorithm 3 as it stands: every hit at every vertex, in order, and nothing that saves work.
/// Takes hits.size() * vertices.size() steps; what the reference itself is checked with.
void deformEverywhere(std::span<DynamicVertex> vertices, std::span<const Hit> hits);

/// The C++ deformation of one target, needing no GPU: what the pipelines are held against, and what shots
/// strike.
///
/// Follows edits of the target's hits at the cost of what they reach: hits at the end are applied to the
/// clusters they reach, any other change takes the clusters concerned from their originals through the hits
/// again.
class ReferenceDeformation {
public:
    /// Starts from the mesh's original vertices. `mesh` outlives this.
    explicit ReferenceDeformation(const RenderMesh& mesh);

    /// Applies hits at the end, in order (all enabled and on this target). Returns the ranges that may have
    /// changed, sorted and merged.
    std::vector<VertexRange> apply(std::span<const Hit> hits);

    /// Notes a change of the target's enabled hits; advance() applies it.
    void edit(const TargetHitsEdit& edit);
    [[nodiscard]] bool isUpToDate() const { return m_concerned.empty() && m_applied == m_dents.size(); }
    /// Applies what was noted until it is done or time is up, asking every few thousand vertices. Returns
    /// isUpToDate().
    bool advance(const IsTimeUp& isTimeUp = {});
    /// The ranges that may have changed since the last call, sorted and merged.
    [[nodiscard]] std::vector<VertexRange> takeChanged() { return m_changed.take(); }

    /// With the hits applied so far. All of them: makes the copy whole.
    [[nodiscard]] std::span<const DynamicVertex> vertices() const { return m_vertices.all(); }
    /// Likewise some.
    [[nodiscard]] std::span<const DynamicVertex> vertices(const VertexRange& range) const {
        return m_vertices.range(range);
    }
    /// The ranges outside of which no vertex has ever been worked on, sorted and merged.
    [[nodiscard]] std::vector<VertexRange> touched() const { return m_reach.rangesOf(m_vertices.copied()); }

private:
    /// What of a hit deforms: a long history is kept in several places.
    struct Dent {
        glm::vec3 point;
        glm::vec3 direction;
        DeformationConstants constants;
        std::shared_ptr<const Hit> formed;  ///< all of the hit; null: its form is the paper's

        [[nodiscard]] static Dent of(const Hit& hit) {
            return {hit.point, hit.direction, hit.constants,
                    hit.form.isPaper() ? nullptr : std::make_shared<const Hit>(hit)};
        }
    };
    [[nodiscard]] Hit hit(std::size_t index) const;

    /// The clusters that one hit reaches, as far as it has been applied.
    struct Progress {
        std::vector<std::uint32_t> reached;
        std::size_t next = 0;  ///< index into `reached`
        [[nodiscard]] bool isDone() const { return next == reached.size(); }
    };
    bool continueHit(const Hit& hit, const IsTimeUp& isTimeUp);
    bool redo(const IsTimeUp& isTimeUp);
    void finishHit();
    void concern(std::span<const Hit> hits);
    void restartConcerned();

    const RenderMesh& m_mesh;
    mutable VertexCopy m_vertices;  ///< of the clusters that hits have reached, unless all are asked for
    ClusterReach m_reach;
    std::vector<Dent> m_dents;
    std::size_t m_applied = 0;  ///< hits begun; the last of them as far as m_progress
    /// Clusters that start from their originals again, ascending; empty: none.
    std::vector<std::uint32_t> m_concerned;
    std::size_t m_redone = 0;  ///< hits begun on them; the last of them as far as m_progress
    Progress m_progress;
    ChangedRanges m_changed;
};

}  // namespace hitscope
