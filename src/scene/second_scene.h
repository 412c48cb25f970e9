// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "analysis/comparison.h"
#include "deform/history_prefix.h"
#include "pipeline/deformation_pipeline.h"
#include "render/renderer.h"
#include "scene/change_upload.h"

namespace hitscope {

/// A session's targets once more on the GPU, under the second pipeline of a comparison. A context is current
/// for every call and the destructor.
class SecondScene {
public:
    /// `session` outlives this.
    explicit SecondScene(Session& session) : m_session(session) {}

    enum class Delivery { WhatHasArrived, All };
    /// Brings it to the session's state and hands the comparison what came back. A pipeline that cannot be
    /// made is told to the comparison. Without a comparison, or one without a second pipeline, all is given
    /// back.
    void follow(Comparison* comparison, const gl::Defines& deformDefines, Delivery delivery);
    /// There is something to draw.
    [[nodiscard]] bool isReady() const { return m_pipeline != nullptr; }
    [[nodiscard]] DeformationPipeline& pipeline() { return *m_pipeline; }
    [[nodiscard]] bool isReadBackPending() const { return m_pipeline && m_pipeline->isReadBackPending(); }
    /// The same targets, as this has them.
    [[nodiscard]] std::vector<DrawItem> itemsFor(std::span<const DrawItem> items) const;
    /// Brings these values to their buffers. The items are the session's targets.
    void uploadChange(const ChangeValues* values, std::span<const DrawItem> items);

private:
    void release();
    bool followPipeline(Comparison& comparison, const gl::Defines& deformDefines);
    void followTargets();
    void readBack(Comparison& comparison, Delivery delivery);

    Session& m_session;
    struct GpuTarget {
        explicit GpuTarget(const Target& target)
            : buffers(target.deformed.render()), changed(target.deformed.sharedRender()) {}
        TargetBuffers buffers;
        ChangedParts changed;
    };
    std::unordered_map<TargetId, std::unique_ptr<GpuTarget>> m_targets;
    std::unique_ptr<DeformationPipeline> m_pipeline;  // below the buffers it is given, so that it goes first
    ChangeUpload m_changeUpload;
    const Comparison* m_comparison = nullptr;
    std::uint64_t m_revision = 0;
    HistoryPrefix m_applied;  // of the history at that revision
    std::optional<PipelineKind> m_tried;
};

}  // namespace hitscope
