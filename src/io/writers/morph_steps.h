// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/ids.h"
#include "deform/hit.h"
#include "io/writers/mesh_export.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// A target whose hits are gone through once more.
struct MorphedTarget {
    TargetId id;
    std::shared_ptr<const RenderMesh> render;
};

/// What a step is made of.
enum class MorphUnit : std::uint8_t {
    Hit,
    Group,  ///< hits of one HitGroup that follow one another; a hit of no group stands alone
};

/// How hits become steps.
struct MorphGrouping {
    MorphUnit unit = MorphUnit::Hit;
    std::size_t most = 1;  ///< > 0; of more units, several make a step, as even as can be
};

/// How many units the hits `rows` of `hits`, which rise, amount to.
[[nodiscard]] std::size_t morphUnitCount(std::span<const Hit> hits, std::span<const std::size_t> rows,
                                         MorphUnit unit);

/// The shapes that targets went through: for each target a list of steps, all of the same length and names;
/// step k is what all hits of part k did, empty where they did nothing to that target. The enabled hits on
/// these targets are divided in history order; without any there are no steps. Made by the reference
/// deformation, at the cost of what the hits reach, on any thread; `hits` are those that made what is shown.
/// Nothing where goOn(fraction), which may be empty, said false.
[[nodiscard]] std::optional<std::vector<std::vector<MorphStep>>> morphSteps(
    std::span<const Hit> hits, std::span<const MorphedTarget> targets, const MorphGrouping& grouping,
    const std::function<bool(double)>& goOn = {});

}  // namespace hitscope
