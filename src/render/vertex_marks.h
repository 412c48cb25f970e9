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
    GLuint indices = 0;     ///< a buffer of render vertices, 32 bits each
    GLsizei count = 0;
    MarkKind kind = MarkKind::Selected;
};

}  // namespace hitscope
