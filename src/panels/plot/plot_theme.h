// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QCustomPlot;
class QWidget;

namespace hitscope {

/// Background, axes, grid and fonts of a plot as `owner`'s palette and font have them; it is painted when the
/// window is. Call again when they change.
void applyPlotTheme(QCustomPlot& plot, const QWidget& owner);

}  // namespace hitscope
