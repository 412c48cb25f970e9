// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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
    struct Uploaded {
        gl::Buffer vertices;
        gl::VertexArray array;
        GLsizei original = 0;  ///< vertices, the first ones
        GLsizei deformed = 0;  ///< after them
        glm::vec3 middle{0.0f};
        std::shared_ptr<const SectionLines> lines;
    };
    void upload(Uploaded& to, const std::shared_ptr<const SectionLines>& lines) const;
    [[nodiscard]] const Uploaded& uploaded(const std::shared_ptr<const SectionLines>& lines);
    void drawLines(const FrameContext& context, const gl::Program& program, const Uploaded& section,
                   bool hidden) const;

    std::array<Uploaded, 2> m_uploaded;  ///< two pictures side by side have one each
    std::size_t m_latest = 0;            ///< the one drawn last
};

/// The pane that stands for the plane, about the frame's targets.
[[nodiscard]] Status drawCutPane(const FrameContext& context);

}  // namespace hitscope::render
