// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <QImage>

#include "render/renderer.h"

namespace hitscope::test {

/// Levels by which a picture may be off from the same one whose lines were blended with pauses: softpipe
/// rounds what it blends when it writes it to the picture.
[[nodiscard]] int blendedLevels();

struct Drawn {
    QImage picture;
    GLuint primitives = 0;  ///< 0: the renderer does not count them
};

/// The test fails if it cannot be drawn.
[[nodiscard]] Drawn drawCounted(Renderer& renderer, const Frame& frame, DeformationPipeline& pipeline,
                                int samples = 1);

/// The share of the primitives that is drawn where it is known what is hidden, or where the renderer does not
/// count them, 0.5; -1: the picture is another one than of all of them.
[[nodiscard]] double drawnShare(Renderer& renderer, const Frame& frame, DeformationPipeline& pipeline,
                                int samples = 1);

}  // namespace hitscope::test
