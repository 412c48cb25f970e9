// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "deform/cluster_reach.h"
#include "pipeline/capture_pass.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/hit_arrays.h"
#include "pipeline/hit_window.h"
#include "pipeline/read_back_queue.h"

namespace hitscope {

/// The paper's method 1 (section 2.1, Algorithm 1): the last hits stand in uniform arrays, and whoever draws
/// a target applies them to its original vertices, every frame. The dynamic buffer is never written. As the
/// paper has it the arrays hold the last hits of the scene, and every target loops over them all; culled,
/// they hold the last hits on each target, and it loops over those that can reach it.
class UniformArrayPipeline final : public DeformationPipeline {
public:
    /// `kind` is UniformArray or UniformArrayCulled.
    [[nodiscard]] static Result<std::unique_ptr<DeformationPipeline>> create(PipelineKind kind,
                                                                             const PipelineOptions& options);

    [[nodiscard]] const PipelineTraits& traits() const override { return pipelineTraits(m_kind); }
    [[nodiscard]] CapacityReport capacity() const override;
    void addTarget(TargetId target, TargetBuffers& buffers) override;
    void removeTarget(TargetId target) override;
    /// Captures what the drawing programs compute, with the same code over the same vertices.
    void readBack(const ReadBackSink& sink) override;
    void pollReadBack(const ReadBackSink& sink) override;
    [[nodiscard]] bool isReadBackPending() const override;
    [[nodiscard]] const ClusterReach* reach(TargetId target) const override;
    [[nodiscard]] gl::Defines drawDefines() const override;
    void prepareDraw(const gl::Program& program, TargetId target) override;

private:
    void startOver(std::span<const Hit> history) override;
    void follow(const HistoryEdit& edit) override;
    struct TargetState {
        TargetState(TargetBuffers& targetBuffers, std::uint64_t firstEpoch)
            : buffers(&targetBuffers),
              reach(targetBuffers.clusters(), targetBuffers.clusterTree()),
              born(firstEpoch),
              epoch(firstEpoch) {}
        TargetBuffers* buffers;
        ClusterReach reach;
        ChangedRanges unread;
        std::uint64_t born;         ///< its first epoch: what was asked for before is of another mesh
        std::uint64_t epoch;        ///< another one whenever the past of the vertices is rewritten
        std::vector<KeptHit> kept;  ///< in order
        std::size_t page = 0;       ///< its hits are [firstHit, lastHit) of that page's arrays
        std::size_t firstHit = 0;
        std::size_t lastHit = 0;
    };
    /// Arrays as a program has them at a time.
    struct Page {
        HitArrays arrays;
        std::uint64_t stamp = 0;  ///< names what is in them, among all pipelines there ever were
    };
    /// Arrays in a program, and what captures with it.
    struct Way {
        HitRoom room;
        CapturePass pass;
    };
    UniformArrayPipeline(PipelineKind kind, Way way, PipelineOptions options);
    [[nodiscard]] static Result<Way> wayIn(std::span<const HitRoom> rooms, const PipelineOptions& options);
    [[nodiscard]] Way& way() { return m_usesForms ? *m_forms : m_paper; }
    [[nodiscard]] const Way& way() const { return m_usesForms ? *m_forms : m_paper; }
    [[nodiscard]] bool isKept(const Hit& hit) const;
    [[nodiscard]] bool needsForms(std::size_t firstHit) const;
    void takeUpForms();
    [[nodiscard]] bool isCulled() const { return m_kind == PipelineKind::UniformArrayCulled; }
    [[nodiscard]] HitWindow& windowOf(TargetId target);
    void push(std::size_t index, std::vector<KeptHit>& dropped);
    void append(std::size_t firstHit);
    void refill();
    void keepWhatWindowsHold(const std::set<TargetId>& targets);
    void reconsider(TargetState& target, std::span<const Hit> changed);
    void fillPages();
    static void show(Page& page, const gl::Program& program);
    void requestReadBack();
    [[nodiscard]] ReadBackQueue::Take delivery(const ReadBackSink& sink);

    PipelineKind m_kind;
    PipelineOptions m_options;
    Way m_paper;                 ///< for hits with the paper's function
    std::optional<Way> m_forms;  ///< for hits of all forms; made when there is one
    bool m_triedForms = false;
    bool m_usesForms = false;
    std::vector<KeptHit> m_history;  ///< all of it; `index` is set when one is kept
    std::uint64_t m_nextSerial = 1;
    std::uint64_t m_lastEpoch = 0;            ///< of all targets, gone ones too: none comes twice
    std::map<TargetId, HitWindow> m_windows;  ///< as the paper has it: one, of no target
    std::vector<std::size_t> m_dropped;       ///< indices into the history, ascending
    std::map<TargetId, TargetState> m_targets;
    std::vector<Page> m_pages;
    ReadBackQueue m_readBack;
};

}  // namespace hitscope
