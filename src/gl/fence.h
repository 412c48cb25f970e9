// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

namespace hitscope::gl {

/// A point in the context's commands. The context is current for every call and the destructor.
class Fence {
public:
    /// After all commands so far, which are on their way to the GPU then.
    Fence();
    ~Fence();
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    /// Whether the GPU has got there; does not wait for it.
    [[nodiscard]] bool isPassed() const;
    /// Until it has; a second at most.
    void wait() const;

private:
    GLsync m_sync;
};

}  // namespace hitscope::gl
