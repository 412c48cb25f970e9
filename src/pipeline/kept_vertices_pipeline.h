// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>
#include <vector>

#include "deform/cluster_reach.h"
#include "deform/hits_by_target.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/hit_batch.h"
#include "pipeline/read_back_queue.h"
#include "pipeline/undo_ring.h"

namespace hitscope {

/// What pipelines have in common that apply a hit once and keep the deformed vertices in the dynamic buffer:
/// everything but how a batch of hits is applied to the clusters it reaches.
///
/// More hits cost what they reach. A change of earlier ones is undone from what was kept of the vertices
/// where it is among the last, and re-applied otherwise, in the clusters concerned only, from their
/// originals.
class KeptVerticesPipeline : public DeformationPipeline {
public:
    [[nodiscard]] CapacityReport capacity() const override { return {}; }
    void addTarget(TargetId target, TargetBuffers& buffers) override;
    void removeTarget(TargetId target) override;
    void readBack(const ReadBackSink& sink) override;
    void pollReadBack(const ReadBackSink& sink) override;
    [[nodiscard]] bool isReadBackPending() const override;
    [[nodiscard]] const ClusterReach* reach(TargetId target) const override;
    // The dynamic buffer holds the deformed vertices: there is nothing to tell a program.
    [[nodiscard]] gl::Defines drawDefines() const override { return {}; }
    void prepareDraw(const gl::Program& /*program*/, TargetId /*target*/) override {}

private:
    void startOver(std::span<const Hit> history) override;
    void follow(const HistoryEdit& edit) override;
    /// Applies a finished batch to the dynamic buffer, and changes no other vertices.
    virtual void deform(TargetId target, TargetBuffers& buffers, const HitBatch& batch) = 0;
    // For who keeps or needs more of a target: targets come and go, and vertices are put back to an earlier
    // state.
    virtual void learnTarget(TargetId /*target*/, TargetBuffers& /*buffers*/) {}
    virtual void forgetTarget(TargetId /*target*/) {}
    virtual void followWrites(TargetId /*target*/, const TargetBuffers& /*buffers*/,
                              std::span<const VertexRange> /*ranges*/) {}

    struct TargetState {
        TargetState(TargetId targetId, TargetBuffers& targetBuffers, std::uint64_t firstEpoch)
            : id(targetId),
              buffers(&targetBuffers),
              reach(targetBuffers.clusters(), targetBuffers.clusterTree()),
              batch(targetBuffers.clusters()),
              born(firstEpoch),
              epoch(firstEpoch) {}
        TargetId id;
        TargetBuffers* buffers;
        ClusterReach reach;
        HitBatch batch;
        ChangedRanges moved;   ///< since the original
        ChangedRanges unread;  ///< since they were last asked for
        std::uint64_t born;    ///< its first epoch: what was asked for before is of another mesh
        std::uint64_t epoch;   ///< another one whenever the past of the vertices is rewritten
        std::vector<std::uint32_t> reached;
    };
    enum class Arrival { Live, Bulk };
    void change(TargetState& target, const TargetHitsEdit& edit);
    void append(TargetState& target, std::size_t firstHit, Arrival arrival);
    [[nodiscard]] bool goBack(TargetState& target, const TargetHitsEdit& edit);
    void redo(TargetState& target, const TargetHitsEdit& edit);
    std::vector<VertexRange> flush(TargetState& target, std::size_t firstHit, Arrival arrival);
    void tighten(TargetState& target, std::span<const VertexRange> ranges);
    void rewritten(TargetState& target, std::span<const VertexRange> ranges);
    void requestReadBack(std::size_t most);
    [[nodiscard]] ReadBackQueue::Take delivery(const ReadBackSink& sink);

    HitsByTarget m_hits;
    std::unordered_map<TargetId, TargetState> m_targets;
    std::uint64_t m_lastEpoch = 0;  ///< of all targets, gone ones too: none comes twice
    ReadBackQueue m_readBack;
    UndoRing m_undo;

    /// Vertices that one pollReadBack() asks for: taking over a million at once would hold a frame up.
    static constexpr std::size_t kMostAPoll = 65'536;
};

}  // namespace hitscope
