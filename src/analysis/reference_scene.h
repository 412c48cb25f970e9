// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "deform/history_prefix.h"
#include "deform/hits_by_target.h"
#include "deform/reference.h"
#include "session/session.h"

namespace hitscope {

/// A session with no GPU: the reference, which is to be its pipeline, applies its hits on the CPU. SceneGpu
/// does the same, and draws.
class ReferenceScene {
public:
    /// `session` outlives this, and nothing else writes its read-back.
    explicit ReferenceScene(Session& session);

    /// Brings the read-back to the session's state: targets, hits, how many of them are shown. Costs what
    /// they reach, unless the history has been rewritten since.
    void sync();

private:
    struct Followed {
        explicit Followed(std::shared_ptr<const RenderMesh> itsMesh)
            : mesh(std::move(itsMesh)), deformation(*mesh) {}
        std::shared_ptr<const RenderMesh> mesh;
        ReferenceDeformation deformation;
    };
    void followTargets();
    void followHistory();
    void startOver();
    void begin(TargetId target, std::shared_ptr<const RenderMesh> mesh);

    Session& m_session;
    ReadBack& m_readBack;
    std::unordered_map<TargetId, Followed> m_targets;
    HistoryPrefix m_applied;
    HitsByTarget m_hits;
    std::uint64_t m_seenRevision = 0;  ///< of the history
    bool m_hasStarted = false;
};

}  // namespace hitscope
