// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "deform/pipeline_kind.h"

namespace hitscope {

/// A pipeline's own colour, the same in every plot; told apart on light and on dark.
[[nodiscard]] QColor pipelineColour(PipelineKind pipeline);

}  // namespace hitscope
