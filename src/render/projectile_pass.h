// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/frame_context.h"

namespace hitscope::render {

/// Projectiles: spheres, one instance each, drawn as finely as they are large in the picture. A context is
/// current for every call and the destructor.
class ProjectilePass {
public:
    ProjectilePass();
    [[nodiscard]] Status draw(const FrameContext& context);

    static constexpr std::size_t kLevels = 4;

private:
    struct Level {
        gl::Buffer vertices;
        gl::Buffer indices;
        gl::VertexArray array;
        GLsizei indexCount = 0;
    };
    Level m_levels[kLevels];  ///< the finest first
    gl::Buffer m_instances;
};

}  // namespace hitscope::render
