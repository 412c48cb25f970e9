// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"

namespace hitscope::gl {

/// What the current context is, for the interface, the benchmark's header and the notes.
struct RendererInfo {
    std::string vendor;
    std::string renderer;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string version;   ///< "4.5 (Core Profile) Mesa 22.3.6"
    int major = 0;
    int minor = 0;
    int maxVertexUniformComponents = 0;

    /// The CPU draws: what a GPU does on the side costs time here.
    [[nodiscard]] bool isSoftware() const;
};
[[nodiscard]] RendererInfo rendererInfo();

/// Comes back when all that was asked of the current context is done (glFinish).
void finish();

/// Turns debug output on where the driver has it (KHR_debug); messages of GL errors are collected. Call once,
/// context current.
void collectDebugMessages();
/// The GL errors since the last call, from glGetError and debug output, in words; empty when there were none.
[[nodiscard]] std::vector<std::string> takeErrors();

/// A core-profile context (3.3 or newer) with no window and no display server: surfaceless EGL. It has no
/// default framebuffer.
class OffscreenContext {
public:
    [[nodiscard]] static Result<std::unique_ptr<OffscreenContext>> create();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;
    void makeCurrent();

private:
    OffscreenContext() = default;
    void* m_display = nullptr;
    void* m_context = nullptr;
};

}  // namespace hitscope::gl
