// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
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

/// What the active pipeline made of the targets; nothing while that is on its way.
[[nodiscard]] std::vector<SavedPositions> capturePositions(const Session& session);

/// New ids for targets, by the old ones.
using TargetNumbers = std::map<TargetId, TargetId>;
/// Gives the targets the ids from `first` on, in their order, wherever the document names them. A session
/// needs ids that it never had, a file those from 1.
TargetNumbers numberTargets(std::uint32_t first, SessionDocument& document);

/// Gives the files their paths from `folder`, where the document is to be saved.
void nameFilesFrom(const QString& folder, SessionDocument& document);

}  // namespace hitscope
