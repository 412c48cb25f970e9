// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/frame_context.h"

namespace hitscope::render {

/// Projectiles: one small sphere, one instance each. A context is current for every call and the destructor.
class ProjectilePass {
public:
    ProjectilePass();
    [[nodiscard]] Status draw(const FrameContext& context);

private:
    gl::Buffer m_vertices;
    gl::Buffer m_indices;
    gl::Buffer m_instances;
    gl::VertexArray m_array;
    GLsizei m_indexCount = 0;
};

}  // namespace hitscope::render
