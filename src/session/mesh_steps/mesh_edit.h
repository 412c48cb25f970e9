// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/ids.h"
#include "session/mesh_steps/mesh_step.h"
#include "session/session_undo.h"
#include "session/target.h"

namespace hitscope {

class Session;

/// What a person wants done to a target's mesh, before it is known where on the mesh that is.
struct MeshEdit {
    enum class Where : std::uint8_t {
        Whole,
        Selection,  ///< `selected`
        Hits,       ///< what hits reach, or, where they are applied first, what they moved and its neighbours
        Aim,        ///< `aim`
    };
    MeshStep step;  ///< its region is worked out; MergedHits: only what appliesHits says
    Where where = Where::Whole;
    bool appliesHits = false;             ///< the dented shape becomes the original before the step is done
    std::vector<std::uint32_t> selected;  ///< ascending
    RegionBall aim;
    std::vector<Hit> hits;  ///< all on the target, disabled ones too

    [[nodiscard]] SessionUndo::Kind kind() const;  ///< what the step to undo is called
};

/// What came of it: the steps done, and the mesh.
struct EditedMesh {
    MeshSteps steps;
    MeshData mesh;
};

/// An edit of a target with the hits and the selected vertices that there are.
[[nodiscard]] MeshEdit meshEdit(const Session& session, TargetId target, MeshStep step);

/// On any thread. Errors: those of withStep(); nothing is selected, or there are no hits, where these are the
/// region.
[[nodiscard]] Result<EditedMesh> edited(const MeshData& mesh, const MeshEdit& edit,
                                        const MeshGoOn& goOn = {});

/// Of the faces that such an edit is about, as the mesh is: metres; 0: there are none. On any thread.
[[nodiscard]] float longestEdge(const MeshData& mesh, const MeshEdit& edit);

/// The target with that mesh: all that takes time to make. On any thread.
[[nodiscard]] TargetState stateWith(const TargetState& target, EditedMesh mesh);

/// Gives the target of that state its mesh, as one step to undo; hits stay but for those that were applied,
/// selected vertices where their numbers hold. Errors: the target is gone, its hits are others, or it has
/// more than kMostMeshSteps.
[[nodiscard]] Status takeEdited(Session& session, const TargetState& state, const MeshEdit& edit);

}  // namespace hitscope
