// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/deformation_pipeline.h"

namespace hitscope::render {

/// Applies no hits: what draws targets as they were (DrawItem::original).
class OriginalShape final : public DeformationPipeline {
public:
    [[nodiscard]] const PipelineTraits& traits() const override {
        return pipelineTraits(PipelineKind::Reference);
    }
    [[nodiscard]] CapacityReport capacity() const override { return {}; }
    void addTarget(TargetId, TargetBuffers&) override {}
    void removeTarget(TargetId) override {}
    void readBack(const ReadBackSink&) override {}
    void pollReadBack(const ReadBackSink&) override {}
    [[nodiscard]] bool isReadBackPending() const override { return false; }
    [[nodiscard]] const ClusterReach* reach(TargetId) const override { return nullptr; }
    [[nodiscard]] gl::Defines drawDefines() const override { return {}; }
    void prepareDraw(const gl::Program&, TargetId) override {}

private:
    void startOver(std::span<const Hit>) override {}
    void follow(const HistoryEdit&) override {}
};

}  // namespace hitscope::render
