// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bench/report.h"

namespace hitscope::bench {

/// What every report starts with: program, renderer, OpenGL, processor, picture size, date, and what the
/// figures are worth. width, height in pixels; 0: nothing is drawn. A context is current.
[[nodiscard]] std::vector<std::pair<QString, QString>> reportHeader(int width, int height);

}  // namespace hitscope::bench
