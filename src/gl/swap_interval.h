// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope::gl {

/// 0: the window that the current context draws into shows its frames at once, as many as there are; 1: with
/// the screen's refresh. Returns whether the platform can set that (EGL, or GLX with GLX_EXT_swap_control or
/// GLX_MESA_swap_control); false too when no window is current.
bool setSwapInterval(int interval);

}  // namespace hitscope::gl
