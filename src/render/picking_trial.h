// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deform/renderer_verdict.h"
#include "gl/program.h"

namespace hitscope {

/// Draws a plate of some thousand triangles and vertices through PickPass, in one draw, and holds what it
/// says of each pixel against what a ray on the CPU meets there, and of each vertex's pixel against that
/// vertex. First plainly; if that is wrong, by a geometry shader; the verdict
/// is of the better way. `defines` are added to the programs. A context is current; its state is left as it
/// was.
[[nodiscard]] PickingVerdict tryPicking(const gl::Defines& defines = {});

}  // namespace hitscope
