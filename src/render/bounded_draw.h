// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

#include "render/frame_context.h"

namespace hitscope::render {

/// glDrawElements() of so many indices of the bound vertex array, from its `first`. A software renderer keeps
/// what it has transformed until it is shaded, some hundred bytes a triangle, and transforms as far ahead as
/// it gets: with millions of triangles that is more than the mesh. So it gets these in pieces, and waits for
/// the last piece but one.
inline void drawBounded(const FrameContext& context, GLenum mode, std::uint32_t first, std::uint32_t count) {
    constexpr std::uint32_t kPiece = 3 << 16;      // indices; whole triangles and whole lines
    constexpr GLuint64 kPatience = 1'000'000'000;  // nanoseconds
    GLsync before = nullptr;
    for (std::uint32_t done = 0; done < count;) {
        const std::uint32_t piece = context.software && count - done > kPiece ? kPiece : count - done;
        const auto* const offset =
            reinterpret_cast<const void*>(sizeof(std::uint32_t) * (std::size_t{first} + done));
        glDrawElements(mode, static_cast<GLsizei>(piece), GL_UNSIGNED_INT, offset);
        done += piece;
        if (count > kPiece && context.software) {
            const GLsync now = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
            glFlush();
            if (before != nullptr) {
                glClientWaitSync(before, 0, kPatience);
                glDeleteSync(before);
            }
            before = now;
        }
    }
    if (before != nullptr) {
        glDeleteSync(before);
    }
}

}  // namespace hitscope::render
