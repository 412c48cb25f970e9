// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/program.h"
#include "render/renderer.h"

namespace hitscope::render {

/// What a program that draws targets needs for the frame's cutting plane; empty where there is none, so that
/// a frame without one is drawn by programs that know of none.
[[nodiscard]] gl::Defines cutDefines(const Frame& frame);
/// Sets cut.glsl's uniforms; the program is in use.
void setCut(const gl::Program& program, const Frame& frame);

/// Whether opaque surfaces close where the plane cuts: programs with HITSCOPE_CUT_FILLED, of cut_fill.glsl.
[[nodiscard]] bool isCutFilled(const Frame& frame);
/// Sets its uniforms, apart from the camera's; the program is in use.
void setCutFill(const gl::Program& program, const Frame& frame);

/// While it lives, what the frame's cutting plane hides is clipped: of programs built with cutDefines() and
/// no others, whose clip distance would be anything.
class ClipByCut {
public:
    explicit ClipByCut(const Frame& frame);
    ~ClipByCut();
    ClipByCut(const ClipByCut&) = delete;
    ClipByCut& operator=(const ClipByCut&) = delete;

private:
    bool m_on;
};

}  // namespace hitscope::render
