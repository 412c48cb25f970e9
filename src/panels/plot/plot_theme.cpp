// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/plot/plot_theme.h"

#include "panels/plot/custom_plot.h"

namespace hitscope {

void applyPlotTheme(QCustomPlot& plot, const QWidget& owner) {
    const QPalette& palette = owner.palette();
    const QColor ink = palette.color(QPalette::WindowText);
    QColor faint = ink;
    faint.setAlphaF(0.15f);
    QColor dim = ink;
    dim.setAlphaF(0.6f);
    plot.setBackground(palette.brush(QPalette::Base));
    // With other changes of the window: at once, each plot would have all of the window put together anew.
    plot.setPlottingHint(QCP::phImmediateRefresh, false);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setBasePen(QPen(dim, 1));
        axis->setTickPen(QPen(dim, 1));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(ink);
        axis->setLabelColor(dim);
        axis->setTickLabelFont(owner.font());
        axis->setLabelFont(owner.font());
        axis->grid()->setPen(QPen(faint, 1));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
}

}  // namespace hitscope
