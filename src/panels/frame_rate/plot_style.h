// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

#include "pipeline/pipeline_kind.h"

class QCustomPlot;

namespace hitscope {

/// Background, axes, grid and fonts of a plot as the widget's palette and font have them.
void applyPlotStyle(QCustomPlot& plot);
/// A pipeline's own colour, the same in every plot; told apart on light and on dark.
[[nodiscard]] QColor pipelineColour(PipelineKind pipeline);

}  // namespace hitscope
