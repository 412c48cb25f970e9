// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "deform/exactness.h"
#include "gl/program.h"

namespace hitscope {

/// For every program that includes deform.glsl: the variant that was measured.
[[nodiscard]] gl::Defines definesOf(const Exactness& exactness);

/// Deforms some thousand vertices, many of them within a few units in the last place of the rim, through a
/// vertex shader with transform feedback and by deform(), and compares. First with the renderer's own
/// division and square root; if they are not exact, corrected by fma; the result is of the variant that is
/// exact, else of the renderer's own. Only vertex shaders are measured: fragment and compute shaders are
/// taken to calculate alike. `defines` are added to the programs. A context is current; its state is left as
/// it was. The error is the driver's, when it does not accept the shader.
[[nodiscard]] Result<Exactness> measureExactness(const gl::Defines& defines = {});

}  // namespace hitscope
