// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "document/session_document.h"

namespace hitscope {

class Session;

/// What of a session document the session does not know: how the window looks at it.
struct CapturedView {
    SavedCameras cameras;
    DisplayOptions display;
};

/// A session as it is now. Costs a copy of its hits and, where the read-back is up to date, a pass over the
/// positions for their fingerprints; where it is not, their fingerprints are left out. Files have no relative
/// paths yet: see nameFilesFrom().
[[nodiscard]] SessionDocument captureSession(const Session& session, const CapturedView& view);

/// Everything of it but hits and fingerprints, for what is captured often.
[[nodiscard]] SessionDocument captureSettings(const Session& session, const CapturedView& view);

/// Of these targets that there are, nothing else.
[[nodiscard]] SessionDocument captureTargets(const Session& session, const std::set<TargetId>& targets);

/// Everything of it but fingerprints: see copyPositions().
[[nodiscard]] SessionDocument captureHits(const Session& session, const CapturedView& view);

/// What the active pipeline made of the targets; nothing while that is on its way.
[[nodiscard]] std::vector<SavedPositions> capturePositions(const Session& session);

/// A target's positions, for another thread.
struct CopiedPositions {
    TargetId target;
    std::vector<glm::vec3> positions;  ///< metres, local frame
};
/// For a large mesh a third of what capturePositions() takes; likewise nothing while they are on their way.
[[nodiscard]] std::vector<CopiedPositions> copyPositions(const Session& session);
/// The rest of it; of any thread, and may be given up.
[[nodiscard]] std::vector<SavedPositions> fingerprintsOf(std::span<const CopiedPositions> copies);

/// New ids for targets, by the old ones.
using TargetNumbers = std::map<TargetId, TargetId>;
/// Gives the targets the ids from `first` on, in their order, wherever the document names them. A session
/// needs ids that it never had, a file those from 1.
TargetNumbers numberTargets(std::uint32_t first, SessionDocument& document);

/// Gives the files their paths from `folder`, where the document is to be saved.
void nameFilesFrom(const QString& folder, SessionDocument& document);

}  // namespace hitscope
