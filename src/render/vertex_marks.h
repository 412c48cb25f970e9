// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>

#include "core/ids.h"
#include "gl/objects.h"
#include "pipeline/target_buffers.h"

namespace hitscope {

enum class MarkKind : std::uint8_t { Selected, Picked, Hovered };

/// Vertices of a target to draw as dots, where its pipeline has them.
struct VertexMarks {
    TargetId target;
    const TargetBuffers* buffers = nullptr;
    glm::mat4 model{1.0f};  ///< rigid
    /// A buffer of render vertices, 32 bits each. Where many fall on the same pixels only the first so many
    /// are drawn: they are to be spread evenly over all.
    GLuint indices = 0;
    GLsizei count = 0;
    MarkKind kind = MarkKind::Selected;
};

}  // namespace hitscope
