// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "gl/objects.h"
#include "render/frame_context.h"

namespace hitscope::render {

/// Draws where the cutting plane cuts, and the plane itself while it is being moved. A context is current for
/// every call and the destructor.
class SectionPass {
public:
    SectionPass();
    /// Blending and depth test are on, depth writes are off.
    [[nodiscard]] Status draw(const FrameContext& context);

private:
    void upload(const SectionLines& lines);
    void drawLines(const FrameContext& context, const gl::Program& program, bool hidden) const;

    gl::Buffer m_vertices;
    gl::VertexArray m_array;
    GLsizei m_original = 0;  ///< vertices, the first ones
    GLsizei m_deformed = 0;  ///< after them
    glm::vec3 m_middle{0.0f};
    std::shared_ptr<const SectionLines> m_uploaded;
};

/// The pane that stands for the plane, about the frame's targets.
[[nodiscard]] Status drawCutPane(const FrameContext& context);

}  // namespace hitscope::render
