// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "session/target_plan.h"

namespace hitscope {

/// A row of the paper's tables 1 and 2: how many of each of its meshes stand in the scene.
struct PaperRow {
    int lowPolyCubes = 0;
    int highPolyCubes = 0;
    int lowPolySpheres = 0;
    int highPolySpheres = 0;
    [[nodiscard]] int targets() const {
        return lowPolyCubes + highPolyCubes + lowPolySpheres + highPolySpheres;
    }
    /// "3 low-poly cubes, 3 high-poly cubes, 5 low-poly spheres, 5 high-poly spheres", without what there is
    /// none of.
    [[nodiscard]] QString label() const;
};

/// The nine rows, in the tables' order; 16 targets each.
[[nodiscard]] std::span<const PaperRow> paperRows();
/// The row that commands take where none is named: one with all four meshes.
inline constexpr int kDefaultPaperRow = 1;

/// The targets of a row on the paper's grid: 4 x 4, 15 m apart, each of half extent (or radius) 2.5 m,
/// standing on y = 0; low-poly cubes first, then high-poly cubes, low-poly spheres, high-poly spheres.
[[nodiscard]] std::vector<TargetPlan> planPaperRow(const PaperRow& row);

}  // namespace hitscope
