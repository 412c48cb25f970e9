// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "deform/capacity_report.h"
#include "deform/exactness.h"
#include "deform/pipeline_kind.h"
#include "deform/renderer_verdict.h"
#include "session/target.h"

namespace hitscope {

namespace test {
struct ReadBackInTests;
}

/// Who may write a session's read-back: SceneGpu, ReferenceScene where there is none, and tests in its place.
class ReadBackAccess {
    friend class SceneGpu;
    friend class ReferenceScene;
    friend struct test::ReadBackInTests;
    ReadBackAccess() = default;
};

/// The way back from the GPU: what the renderer can, what the active pipeline keeps, and what it made of the
/// targets. Belongs to a Session, on its thread.
class ReadBack : public QObject {
    Q_OBJECT
public:
    /// `targets` outlive this.
    explicit ReadBack(const std::vector<std::unique_ptr<Target>>& targets);

    /// Of the renderer that draws; nothing before there is one.
    [[nodiscard]] const std::optional<Exactness>& exactness() const { return m_exactness; }
    /// What has been tried so far of the pipelines and of picking on that renderer.
    [[nodiscard]] const RendererVerdict& verdict() const { return m_verdict; }
    /// Why the driver cannot run a pipeline, in words for the interface; empty: it can, as far as is known.
    [[nodiscard]] QString whyUnavailable(PipelineKind kind) const;
    [[nodiscard]] const CapacityReport& capacity() const { return m_capacity; }
    /// Hits that the active pipeline no longer applies because its capacity was reached.
    [[nodiscard]] std::size_t droppedHits() const { return m_capacity.dropped.size(); }
    [[nodiscard]] bool isDropped(std::size_t index) const;
    /// The CPU copies are what the pipeline makes of the history as it is now: nothing is on its way.
    [[nodiscard]] bool isUpToDate() const { return !m_isBehind; }

    void setExactness(const Exactness& exactness);
    void setVerdict(RendererVerdict verdict);
    void setUnavailablePipelines(std::map<PipelineKind, QString> reasons);
    void setCapacity(CapacityReport report);
    /// The pipeline starts over: every target's CPU copy goes back to its original until it is read back.
    void restart();
    /// What the active pipeline made of a target: vertices [first, first + vertices.size()).
    void take(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices);
    struct ChangedNormals {
        TargetId target;
        std::vector<std::uint32_t> renderVertices;  ///< sorted, each once
    };
    /// All has been taken: recomputes true normals around what moved and emits meshChanged() for each target
    /// concerned. Returns the render vertices whose shading normal changed.
    std::vector<ChangedNormals> finish();
    void setUpToDate() { m_isBehind = false; }

    // For the session.
    void expectMoves() { m_isBehind = true; }  ///< until setUpToDate()
    void forget(TargetId target) { m_moved.erase(target); }
    void forgetAll() { m_moved.clear(); }

Q_SIGNALS:
    void exactnessChanged();
    void verdictChanged();
    void unavailablePipelinesChanged();
    void capacityChanged();
    void meshChanged(hitscope::TargetId target);  ///< its DeformedMesh did
    /// Before that: which render vertices moved, or have another true normal. Sorted.
    void shadingChanged(hitscope::TargetId target, const std::vector<std::uint32_t>& renderVertices);
    /// Before that: which file vertices are now somewhere else, in no order; some may be repeated.
    void verticesMoved(hitscope::TargetId target, const std::vector<std::uint32_t>& vertices);

private:
    const std::vector<std::unique_ptr<Target>>& m_targets;
    std::optional<Exactness> m_exactness;
    RendererVerdict m_verdict;
    std::map<PipelineKind, QString> m_unavailablePipelines;
    CapacityReport m_capacity;
    std::map<TargetId, std::vector<std::uint32_t>> m_moved;  ///< file vertices, since the last finish()
    bool m_isBehind = false;
};

}  // namespace hitscope
