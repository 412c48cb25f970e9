// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>

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
    /// "3 LP cubes, 3 HP cubes, 5 LP spheres, 5 HP spheres"
    [[nodiscard]] QString label() const;
};

/// The nine rows, in the tables' order.
[[nodiscard]] std::span<const PaperRow> paperRows();
/// The row that the window opens on: one with all four meshes.
inline constexpr int kDefaultPaperRow = 1;

}  // namespace hitscope
