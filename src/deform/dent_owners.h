// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "deform/hit.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// Which hits make one dent however they overlap: those of one stroke of the brush, and those at one place
/// (nearer to each other than kOnePlace of the shorter reach). One number a hit: the index of the first of
/// those that it is together with.
[[nodiscard]] std::vector<std::uint32_t> dentsOfHits(std::span<const Hit> hits);
inline constexpr float kOnePlace = 0.1f;

/// To which dent each vertex belongs where dents overlap: to that whose hits together moved it farthest;
/// where two moved it as far, as within the cap of both, to the one whose hit was nearer to it then. One
/// entry a vertex: an entry of `dents`, or kNoIndex where no hit moved it.
///
/// `vertices`: of the file. `hits`: those that moved some of them, in order; `dents`: dentsOfHits() of them.
/// By the reference deformation. Empty when isStopped() says so.
[[nodiscard]] std::vector<std::uint32_t> dentOwners(const RenderMesh& mesh,
                                                    std::span<const std::uint32_t> vertices,
                                                    std::span<const Hit> hits,
                                                    std::span<const std::uint32_t> dents,
                                                    const std::function<bool()>& isStopped = {});

}  // namespace hitscope
