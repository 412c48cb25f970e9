// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/renderer.h"

namespace hitscope {

/// A frame with what it refers to.
struct FrameParts {
    FrameParts() = default;
    FrameParts(const FrameParts&) = delete;
    FrameParts& operator=(const FrameParts&) = delete;

    std::vector<DrawItem> items;
    std::vector<ProjectileItem> projectiles;
    std::vector<VertexMarks> marks;
    Frame frame;
    std::uint64_t dataRevision = 0;     ///< of the scene's buffers and materials
    std::uint64_t normalsRevision = 0;  ///< of its shading normals
};

}  // namespace hitscope
