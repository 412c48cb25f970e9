// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include "core/image.h"

namespace hitscope::gl {

/// The colours of a framebuffer (0: none is bound, the default one), averaged down on the GPU to `toWidth` x
/// `toHeight` pixels, so that only these are read. `width`, `height`: the framebuffer's, pixels, > 0 and at
/// least as many. Waits for the GPU; bindings are put back.
[[nodiscard]] Image shrunk(GLuint framebuffer, int width, int height, int toWidth, int toHeight);

}  // namespace hitscope::gl
