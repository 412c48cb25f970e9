// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bench/bench_room.h"
#include "gl/context.h"

namespace hitscope::bench {

/// What every report starts with: program, renderer, OpenGL, processor, picture size, date, and what the
/// figures are worth. width, height in pixels; 0: nothing is drawn.
[[nodiscard]] std::vector<std::pair<QString, QString>> reportHeader(const BenchRoom& room, int width,
                                                                    int height);

/// The same without pipelines: what a report says of the machine, where another program draws.
[[nodiscard]] std::vector<std::pair<QString, QString>> machineHeader(const gl::RendererInfo& renderer,
                                                                     const QString& picture);

}  // namespace hitscope::bench
