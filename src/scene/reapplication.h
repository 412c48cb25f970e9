// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "deform/vertex_range.h"
#include "pipeline/deformation_pipeline.h"
#include "session/task_list.h"

namespace hitscope {

class Session;

/// A long history being applied from the start, some hits a frame: into a pipeline and buffers of its own, so
/// that the picture stays as it was until everything is there, and giving up costs nothing. Hits that arrive
/// meanwhile are applied too. A context is current for every call and the destructor.
class Reapplication {
public:
    using Buffers = std::unordered_map<TargetId, std::unique_ptr<TargetBuffers>>;

    /// Fewer are applied between two frames without anybody noticing.
    static constexpr std::size_t kWorthSlicing = 2000;
    /// Whether so many hits take this pipeline long: those that keep no vertices have nothing to apply.
    [[nodiscard]] static bool isWorthSlicing(PipelineKind kind, std::size_t hits);

    /// `made`: a new pipeline without targets. `cancel`: gives it up from outside; `cancelHelp` says what is
    /// then. `session` outlives this.
    Reapplication(Session& session, std::unique_ptr<DeformationPipeline> made, std::function<void()> cancel,
                  const QString& cancelHelp);

    /// Applies some more hits. Returns whether all are.
    bool advance();
    /// Applies all that are left.
    void finish();
    /// The session's targets are still those it began with.
    [[nodiscard]] bool isOfTheseTargets() const;
    [[nodiscard]] PipelineKind kind() const { return m_pipeline->traits().kind; }
    /// Delivers what the pipeline has delivered so far; the rest is still to be read back from it.
    void deliver(const ReadBackSink& sink);
    [[nodiscard]] Buffers takeBuffers() { return std::move(m_buffers); }
    [[nodiscard]] std::unique_ptr<DeformationPipeline> takePipeline() { return std::move(m_pipeline); }

private:
    void followEdits();
    void applySome(std::size_t most);

    Session& m_session;
    Buffers m_buffers;
    std::unique_ptr<DeformationPipeline> m_pipeline;  // below the buffers, so that it goes first
    /// What has arrived of a target, which the pipeline does not tell again.
    struct Arrived {
        std::vector<DynamicVertex> vertices;
        ChangedRanges ranges;
    };
    std::unordered_map<TargetId, Arrived> m_arrived;
    std::size_t m_applied = 0;  ///< of the hits to be shown
    std::uint64_t m_revision = 0;
    TaskProgress m_progress;
};

}  // namespace hitscope
