// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "core/result.h"
#include "deform/hit.h"
#include "mesh/mesh_data.h"
#include "mesh/refine/refine.h"
#include "mesh/refine/simplify.h"
#include "mesh/refine/smooth.h"

namespace hitscope {

/// Hits become part of the mesh: what the reference makes of them is the original from then on.
struct MergedHits {
    std::vector<Hit> hits;  ///< enabled, in order; their target means nothing
};

/// One object of the mesh is all of it from then on.
struct OnlyObject {
    std::uint32_t index = 0;  ///< of MeshObjects
};

/// Something that was done to a target's mesh as it was read or made: enough to do it again, in every bit.
using MeshStep = std::variant<RefineOptions, SimplifyOptions, SmoothOptions, MergedHits, OnlyObject>;
/// In the order in which they were done.
using MeshSteps = std::vector<std::shared_ptr<const MeshStep>>;

/// More are not done to one target, nor read from a session.
inline constexpr std::size_t kMostMeshSteps = 1'000;

/// What a step makes of a mesh. On any thread. Errors: those of refine(), simplify() and smooth(); hits that
/// leave a coordinate that is not finite; an object that the mesh does not have.
[[nodiscard]] Result<MeshData> withStep(const MeshData& mesh, const MeshStep& step,
                                        const MeshGoOn& goOn = {});
/// One after the other.
[[nodiscard]] Result<MeshData> withSteps(MeshData mesh,
                                         std::span<const std::shared_ptr<const MeshStep>> steps,
                                         const MeshGoOn& goOn = {});

}  // namespace hitscope
