// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/refine/refine_work.h"

namespace hitscope {

// Which edges a pass cuts. An edge is too long where it is longer than the wanted length, a face in the
// region has it, and floats tell its middle from its ends.

/// All that are too long; with `keepsQuads` also those that lie across a quad in the region from one that is
/// cut, strip by strip.
[[nodiscard]] CutEdges longEdges(const RefineWork& work, double length, bool keepsQuads);

/// All of the region if one is too long, else none.
[[nodiscard]] CutEdges everyEdge(const RefineWork& work, double length);

/// Of those that are too long, those which are the longest in every face that has them: no face is cut twice.
/// To cut these until there are none leads to the same mesh as cutting always the longest of all.
[[nodiscard]] CutEdges longestEdges(const RefineWork& work, double length);

/// Whether a polygon in the region has a side or, cut into triangles, a diagonal that is too long.
[[nodiscard]] bool hasLongDiagonal(const RefineWork& work, const RefineWork::Face& face, double length);

/// The longest edge of the region's faces, metres; 0: there is none.
[[nodiscard]] double longestLength(const RefineWork& work);

}  // namespace hitscope
