// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/deformation_pipeline.h"

namespace hitscope::test {

/// The same pipeline, but it keeps to itself where it draws, so that all of a target is drawn.
class Secretive final : public DeformationPipeline {
public:
    explicit Secretive(DeformationPipeline& pipeline) : m_pipeline(pipeline) {}
    [[nodiscard]] const PipelineTraits& traits() const override { return m_pipeline.traits(); }
    [[nodiscard]] CapacityReport capacity() const override { return m_pipeline.capacity(); }
    void addTarget(TargetId target, TargetBuffers& buffers) override {
        m_pipeline.addTarget(target, buffers);
    }
    void removeTarget(TargetId target) override { m_pipeline.removeTarget(target); }
    void readBack(const ReadBackSink& sink) override { m_pipeline.readBack(sink); }
    void pollReadBack(const ReadBackSink& sink) override { m_pipeline.pollReadBack(sink); }
    [[nodiscard]] bool isReadBackPending() const override { return m_pipeline.isReadBackPending(); }
    [[nodiscard]] const ClusterReach* reach(TargetId) const override { return nullptr; }
    [[nodiscard]] gl::Defines drawDefines() const override { return m_pipeline.drawDefines(); }
    void prepareDraw(const gl::Program& program, TargetId target) override {
        m_pipeline.prepareDraw(program, target);
    }

private:
    void startOver(std::span<const Hit>) override {}
    void follow(const HistoryEdit&) override {}

    DeformationPipeline& m_pipeline;
};

}  // namespace hitscope::test
