// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/cut_away.h"

#include <glm/geometric.hpp>

namespace hitscope::render {

gl::Defines cutDefines(const Frame& frame) {
    return frame.options.cut.on ? gl::Defines{{"HITSCOPE_CUT", "1"}} : gl::Defines();
}

void setCut(const gl::Program& program, const Frame& frame) {
    if (frame.options.cut.on) {
        program.set("u_cut", frame.options.cut.kept());
    }
}

bool isCutFilled(const Frame& frame) {
    return frame.options.cut.on && frame.options.cut.fill;
}

void setCutFill(const gl::Program& program, const Frame& frame) {
    const Camera& camera = frame.camera;
    const glm::vec4 kept = frame.options.cut.kept();
    program.set("u_cutFromEye", glm::vec4(glm::vec3(kept), glm::dot(kept, glm::vec4(camera.eye(), 1.0f))));
    program.set("u_sight",
                camera.isOrthographic() ? glm::vec4(camera.forward(), 1.0f) : glm::vec4(camera.eye(), 0.0f));
}

ClipByCut::ClipByCut(const Frame& frame) : m_on(frame.options.cut.on) {
    if (m_on) {
        glEnable(GL_CLIP_DISTANCE0);
    }
}

ClipByCut::~ClipByCut() {
    if (m_on) {
        glDisable(GL_CLIP_DISTANCE0);
    }
}

}  // namespace hitscope::render
