// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace hitscope::gl {

/// A context beside another one, current on a thread of its own. It shares buffers with the other, but
/// neither vertex arrays nor framebuffers.
class SideContext {
public:
    SideContext() = default;
    virtual ~SideContext() = default;  ///< waits for the jobs
    SideContext(const SideContext&) = delete;
    SideContext& operator=(const SideContext&) = delete;
    /// Does `job` on that thread, after those before. What it has written, the other context has after the
    /// job called finish() and was waited for.
    virtual void start(std::function<void()> job) = 0;
};

}  // namespace hitscope::gl
