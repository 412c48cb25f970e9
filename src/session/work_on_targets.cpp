// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/work_on_targets.h"

namespace hitscope {

namespace {

bool isWorkOnTargets(SessionUndo::Kind kind) {
    switch (kind) {
        case SessionUndo::Kind::AddTarget:
        case SessionUndo::Kind::DuplicateTarget:
        case SessionUndo::Kind::PutOnTurntable:
        case SessionUndo::Kind::RemoveTarget:
        case SessionUndo::Kind::MoveTarget:
        case SessionUndo::Kind::RotateTarget:
        case SessionUndo::Kind::RenameTarget:
        case SessionUndo::Kind::TargetPhysics:
        case SessionUndo::Kind::TargetTexture:
        case SessionUndo::Kind::RefineMesh:
        case SessionUndo::Kind::SimplifyMesh:
        case SessionUndo::Kind::SmoothMesh:
        case SessionUndo::Kind::ApplyHits:
        case SessionUndo::Kind::ScaleTarget:
        case SessionUndo::Kind::SeparateObjects:
        case SessionUndo::Kind::PlaceMesh:
            return true;
        default:
            return false;
    }
}

}  // namespace

std::uint64_t workOnTargets(const SessionUndo& steps) {
    for (std::size_t step = steps.done(); step > 0; --step) {
        const SessionUndo::Kind kind = steps.name(step - 1).kind;
        if (kind == SessionUndo::Kind::LoadScene) {
            return 0;
        }
        if (isWorkOnTargets(kind)) {
            return steps.stateAfter(step - 1);
        }
    }
    return 0;
}

}  // namespace hitscope
