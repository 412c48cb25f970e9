// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "deform/renderer_verdict.h"

namespace hitscope {

/// describe() as people read it in the window: with its numbers in the system's locale.
[[nodiscard]] QString verdictText(const PipelineVerdict& verdict);
[[nodiscard]] QString verdictText(const PickingVerdict& verdict);
/// With the pipeline's name before it.
[[nodiscard]] QString verdictText(const RendererVerdict& verdict, PipelineKind kind);

}  // namespace hitscope
