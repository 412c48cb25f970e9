// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/result.h"
#include "session/mesh_steps/mesh_step.h"
#include "session/target_state.h"

namespace hitscope {

class Session;

/// What a target's objects are as targets of their own, in the mesh's order.
struct SeparatedObjects {
    TargetState before;
    std::vector<Hit> hits;           ///< all on the target, disabled ones too
    std::vector<TargetState> parts;  ///< their ids mean nothing
    /// For each hit the parts it moves vertices of, ascending, by index; at least one, and so the parts are
    /// dented together as the target was, in every bit.
    std::vector<std::vector<std::uint32_t>> partsOfHit;
    std::vector<std::vector<std::uint32_t>> vertices;  ///< of each part: see MeshObjects::vertices()
};

/// More targets than that are not made of one.
inline constexpr std::size_t kMostParts = 500;

/// On any thread. `hits`: all on the target, in order. Errors: the mesh has less than two objects, or more
/// than kMostParts, or has had kMostMeshSteps; it was cancelled.
[[nodiscard]] Result<SeparatedObjects> separated(const TargetState& target, std::vector<Hit> hits,
                                                 const MeshGoOn& goOn = {});

/// The parts take the target's place, with the hits and the selected vertices they have of it, as one step to
/// undo. A hit that moves several parts is then one on each. Errors: the target is gone, or its hits are
/// others.
[[nodiscard]] Status takeSeparated(Session& session, const SeparatedObjects& objects);

}  // namespace hitscope
