// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope {

/// How much of a picture is drawn: all, or less while it moves.
struct PictureDetail {
    float scale = 1.0f;   ///< part of width and height that are drawn, and then enlarged
    bool coarse = false;  ///< large targets have fewer triangles: RenderMesh::coarseTriangles

    [[nodiscard]] bool isFull() const { return scale >= 1.0f && !coarse; }
    bool operator==(const PictureDetail&) const = default;
};

}  // namespace hitscope
