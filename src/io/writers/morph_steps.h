// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The shapes that targets went through: for each target a list of steps, all of the same length and names;
/// step k is what all hits of group k did, empty where they did nothing to that target. The enabled hits on
/// these targets are put into groups in history order, at most `most` (> 0), as even as can be; without any
/// there are no steps. Made by the reference deformation, at the cost of what the hits reach, on any thread;
/// `hits` are those that made what is shown. Nothing where goOn(fraction), which may be empty, said false.
[[nodiscard]] std::optional<std::vector<std::vector<MorphStep>>> morphSteps(
    std::span<const Hit> hits, std::span<const MorphedTarget> targets, std::size_t most,
    const std::function<bool(double)>& goOn = {});

}  // namespace hitscope
