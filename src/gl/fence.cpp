// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/fence.h"

namespace hitscope::gl {

Fence::Fence() : m_sync(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) {
    glFlush();
}

Fence::~Fence() {
    glDeleteSync(m_sync);
}

bool Fence::isPassed() const {
    return glClientWaitSync(m_sync, 0, 0) != GL_TIMEOUT_EXPIRED;
}

void Fence::wait() const {
    constexpr GLuint64 kPatience = 1'000'000'000;  // nanoseconds
    glClientWaitSync(m_sync, 0, kPatience);
}

}  // namespace hitscope::gl
