// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/plot_style.h"

#include <qcustomplot.h>

namespace hitscope {

void applyPlotStyle(QCustomPlot& plot) {
    const QPalette palette = plot.palette();
    const QColor ink = palette.color(QPalette::WindowText);
    QColor faint = ink;
    faint.setAlphaF(0.15f);
    QColor dim = ink;
    dim.setAlphaF(0.6f);
    plot.setBackground(palette.brush(QPalette::Base));
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setBasePen(QPen(dim, 1));
        axis->setTickPen(QPen(dim, 1));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(ink);
        axis->setLabelColor(dim);
        axis->setTickLabelFont(plot.font());
        axis->setLabelFont(plot.font());
        axis->grid()->setPen(QPen(faint, 1));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
    plot.setBufferDevicePixelRatio(plot.devicePixelRatioF());
}

QColor pipelineColour(PipelineKind pipeline) {
    switch (pipeline) {
        case PipelineKind::UniformArray:
            return {0xe0, 0x7b, 0x2a};
        case PipelineKind::UniformArrayCulled:
            return {0xb8, 0x96, 0x18};
        case PipelineKind::TransformFeedback:
            return {0x3b, 0x82, 0xd6};
        case PipelineKind::Compute:
            return {0x91, 0x62, 0xd4};
        case PipelineKind::Reference:
            return {0x7d, 0x8a, 0x97};
    }
    return {};
}

}  // namespace hitscope
