// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "core/ids.h"
#include "core/result.h"
#include "deform/hit.h"
#include "gl/program.h"
#include "mesh/render_mesh.h"
#include "pipeline/pipeline_kind.h"
#include "pipeline/target_buffers.h"

namespace hitscope {

/// Receives vertices [first, first + vertices.size()) of a target as the pipeline has them.
using ReadBackSink =
    std::function<void(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices)>;

/// A way to apply hits to targets on the GPU. After reset(h) and any appends, each target's mesh is its
/// original with its hits applied in order, whatever the pipeline: on the GPU, in the dynamic buffer or in
/// the vertex shader as the pipeline's nature is. A context is current for every call and the destructor.
class DeformationPipeline {
public:
    virtual ~DeformationPipeline() = default;
    DeformationPipeline() = default;
    DeformationPipeline(const DeformationPipeline&) = delete;
    DeformationPipeline& operator=(const DeformationPipeline&) = delete;

    [[nodiscard]] virtual const PipelineTraits& traits() const = 0;
    /// Most hits kept in the scene; nothing: unlimited.
    [[nodiscard]] virtual std::optional<std::size_t> capacity() const = 0;
    /// Oldest hits of the history that no longer count because the capacity was reached.
    [[nodiscard]] virtual std::size_t droppedHits() const = 0;

    /// `buffers` outlive their registration. They are at their original, and so is what readBack()'s receiver
    /// has of the target.
    virtual void addTarget(TargetId target, TargetBuffers& buffers) = 0;
    virtual void removeTarget(TargetId target) = 0;

    /// Starts over from the originals and applies the whole history. Hits on unknown targets are passed over.
    virtual void reset(std::span<const Hit> history) = 0;
    /// Applies more hits, which come after all those before.
    virtual void append(std::span<const Hit> hits) = 0;

    /// Calls `sink` for every range that may have changed since the last call (after a reset: since before
    /// it, so that the receiver ends with this pipeline's state of every vertex). Waits for the GPU.
    virtual void readBack(const ReadBackSink& sink) = 0;

    /// Definitions for the programs that draw targets; they include hits.glsl, which loops where these say
    /// so.
    [[nodiscard]] virtual gl::Defines drawDefines() const = 0;
    /// Sets the uniforms of hits.glsl on a program built with drawDefines(), in use, before it draws
    /// `target`.
    virtual void prepareDraw(const gl::Program& program, TargetId target) = 0;
};

/// Limits taken from the context unless a test forces smaller ones.
struct PipelineLimits {
    std::optional<int> vertexUniformComponents;
};

[[nodiscard]] Result<std::unique_ptr<DeformationPipeline>> makePipeline(PipelineKind kind,
                                                                        const PipelineLimits& limits = {});

}  // namespace hitscope
