// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/ids.h"
#include "core/result.h"
#include "deform/capacity_report.h"
#include "deform/cluster_reach.h"
#include "deform/hit_history.h"
#include "deform/pipeline_kind.h"
#include "gl/program.h"
#include "mesh/render_mesh.h"
#include "pipeline/target_buffers.h"

namespace hitscope {

/// Receives vertices [first, first + vertices.size()) of a target as the pipeline has them.
using ReadBackSink =
    std::function<void(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices)>;

/// A way to apply hits to targets. After reset(h) and any edits, each target's mesh is its original with its
/// enabled hits applied in order, whatever the pipeline: on the GPU, in the dynamic buffer or in the vertex
/// shader as the pipeline's nature is. A context is current for every call and the destructor.
class DeformationPipeline {
public:
    virtual ~DeformationPipeline() = default;
    DeformationPipeline() = default;
    DeformationPipeline(const DeformationPipeline&) = delete;
    DeformationPipeline& operator=(const DeformationPipeline&) = delete;

    [[nodiscard]] virtual const PipelineTraits& traits() const = 0;
    [[nodiscard]] virtual CapacityReport capacity() const = 0;

    /// `buffers` outlive their registration. They are at their original, and so is what readBack()'s receiver
    /// has of the target. Hits on it that the history has already are applied.
    virtual void addTarget(TargetId target, TargetBuffers& buffers) = 0;
    virtual void removeTarget(TargetId target) = 0;

    /// Starts over from the originals and applies the whole history. Hits on unknown targets are passed over.
    void reset(std::span<const Hit> history);
    /// Follows a change of the history, at the cost of what the hits concerned reach.
    void edit(const HistoryEdit& edit);
    /// Follows an edit that puts these hits at the end.
    void append(std::span<const Hit> hits);

    /// Delivers every vertex that may have changed since it was last delivered (after a reset: since before
    /// it, so that the receiver ends with this pipeline's state of every vertex). Waits for the GPU.
    virtual void readBack(const ReadBackSink& sink) = 0;
    /// Delivers what has arrived of what was asked for before, and asks for what has changed since. Never
    /// waits: what changed in a frame comes a frame or two later, in order.
    virtual void pollReadBack(const ReadBackSink& sink) = 0;
    /// Whether pollReadBack() still has something to deliver.
    [[nodiscard]] virtual bool isReadBackPending() const = 0;

    /// Where the vertices of `target` may be drawn; null: not known. It follows the hits at once, with no
    /// look at the GPU, and is good until the pipeline's next change.
    [[nodiscard]] virtual const ClusterReach* reach(TargetId target) const = 0;

    /// Definitions for the programs that draw targets; they include hits.glsl, which loops where these say
    /// so.
    [[nodiscard]] virtual gl::Defines drawDefines() const = 0;
    /// Sets the uniforms of hits.glsl on a program built with drawDefines(), in use, before it draws
    /// `target`.
    virtual void prepareDraw(const gl::Program& program, TargetId target) = 0;

private:
    virtual void startOver(std::span<const Hit> history) = 0;
    virtual void follow(const HistoryEdit& edit) = 0;

    std::size_t m_historySize = 0;
};

struct PipelineOptions {
    /// As if the context had so many; for tests.
    std::optional<int> vertexUniformComponents;
    /// For programs that include deform.glsl (definesOf()).
    gl::Defines deformDefines;
    /// As if a uniform block could have so many bytes; for tests.
    std::optional<int> uniformBlockBytes;
    /// Buffers that are filled piece by piece begin near their end, where some drivers do not read what was
    /// written; for trials.
    bool startsBuffersLate = false;
};

/// The error is why this context cannot run it, or the driver's.
[[nodiscard]] Result<std::unique_ptr<DeformationPipeline>> makePipeline(PipelineKind kind,
                                                                        const PipelineOptions& options = {});
/// Why the current context cannot run it, in words for people; nothing: it can.
[[nodiscard]] std::optional<std::string> whyUnavailable(PipelineKind kind);

}  // namespace hitscope
