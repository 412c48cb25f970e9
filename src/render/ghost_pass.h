// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/frame_context.h"

namespace hitscope::render {

/// Surfaces that are not there yet, over all that is: translucent, with their edges. A context is current for
/// every call and the destructor.
class GhostPass {
public:
    GhostPass();
    /// Draws over the frame, and leaves the depth buffer useless.
    [[nodiscard]] Status draw(const FrameContext& context);

private:
    gl::Buffer m_vertices;
    gl::VertexArray m_array;
    std::shared_ptr<const std::vector<glm::vec3>> m_uploaded;  ///< what is in m_vertices
};

}  // namespace hitscope::render
