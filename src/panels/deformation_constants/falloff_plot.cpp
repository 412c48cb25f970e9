// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/falloff_plot.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "panels/plot/custom_plot.h"
#include "panels/plot/plot_theme.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kSamples = 200;
constexpr double kBeyondRim = 1.25;  // of max_distance, shown
constexpr double kHeadroom = 1.35;   // over the largest magnitude, for the labels

enum Graph { Curve, Beyond, Corner };

/// The paper's function (section 2.3) before its rim; r in metres.
double magnitude(const DeformationConstants& constants, double r) {
    const double cap = constants.maxMagnitude;
    return r > 0.0 ? std::min(constants.power / r, cap) : cap;
}

}  // namespace

FalloffPlot::FalloffPlot(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    setMinimumHeight(130);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setToolTip(tr("Displacement of a vertex against its distance from the hit point"));
    m_plot->setMinimumSize(120, 100);
    nameUnit(Unit::Metres);
    m_plot->xAxis->setLabelPadding(1);
    m_plot->yAxis->setLabelPadding(1);
    m_plot->yAxis->ticker()->setTickCount(3);
    m_plot->axisRect()->setMinimumMargins(QMargins(4, 6, 8, 0));
    m_plot->setBufferDevicePixelRatio(devicePixelRatioF());
    for (int graph = Curve; graph <= Corner; ++graph) {
        m_plot->addGraph();
    }
    m_plot->graph(Corner)->setLineStyle(QCPGraph::lsNone);
    makeItems();
    applyPalette();
}

void FalloffPlot::makeItems() {
    m_step = new QCPItemLine(m_plot);
    m_cornerText = new QCPItemText(m_plot);
    m_stepText = new QCPItemText(m_plot);
    m_cornerText->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
    m_stepText->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
    for (QCPItemText* text : {m_cornerText, m_stepText}) {
        text->setPadding(QMargins(4, 2, 4, 2));
        text->setClipToAxisRect(true);
    }
}

void FalloffPlot::applyPalette() {
    applyPlotTheme(*m_plot, *this);
    const QColor line = palette().color(QPalette::Highlight);
    QColor area = line;
    area.setAlphaF(0.25f);
    m_plot->graph(Curve)->setPen(QPen(line, 1.5));
    m_plot->graph(Curve)->setBrush(area);
    m_plot->graph(Beyond)->setPen(QPen(line, 1.5));
    m_plot->graph(Corner)->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, line, 7));
    m_step->setPen(QPen(line, 1.5, Qt::DashLine));
    for (QCPItemText* text : {m_cornerText, m_stepText}) {
        text->setColor(palette().color(QPalette::WindowText));
        text->setFont(font());
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void FalloffPlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        applyPalette();
    }
}

void FalloffPlot::placeCorner(double distance, double magnitude) {
    m_plot->graph(Corner)->setData({distance}, {magnitude}, true);
    m_cornerText->setText(tr("cap up to %1 %2").arg(shownNumber(distance, 'g', 3), m_unit));
    m_cornerText->position->setCoords(distance, magnitude);
}

void FalloffPlot::placeStep(double rim, double step, double above) {
    m_step->start->setCoords(rim, step);
    m_step->end->setCoords(rim, 0.0);
    m_stepText->setText(tr("step of %1 %2").arg(shownNumber(step, 'g', 3), m_unit));
    m_stepText->position->setCoords(rim * kBeyondRim, above);
}

void FalloffPlot::nameUnit(Unit unit) {
    m_unit = unit == Unit::Metres ? tr("m") : tr("%");
    const QString of = unit == Unit::Metres ? m_unit : tr("% of target");
    m_plot->xAxis->setLabel(tr("distance from the hit point (%1)").arg(of));
    m_plot->yAxis->setLabel(tr("displacement (%1)").arg(m_unit));
}

void FalloffPlot::show(const DeformationConstants& constants, Unit unit) {
    nameUnit(unit);
    const double rim = constants.maxDistance;
    const double cap = constants.maxMagnitude;
    const double corner = cap > 0.0 ? constants.power / cap : 0.0;
    QVector<double> distances;
    QVector<double> magnitudes;
    for (int i = 0; i <= kSamples; ++i) {
        const double r = rim * i / kSamples;
        if (corner > 0.0 && corner < r && corner > rim * (i - 1) / kSamples) {
            distances.append(corner);
            magnitudes.append(cap);
        }
        distances.append(r);
        magnitudes.append(magnitude(constants, r));
    }
    const double highest = magnitudes.front();
    m_plot->graph(Curve)->setData(distances, magnitudes, true);
    m_plot->graph(Beyond)->setData({rim, rim * kBeyondRim}, {0.0, 0.0}, true);
    placeCorner(std::min(corner, rim), highest);
    placeStep(rim, magnitudes.back(), std::min(magnitude(constants, 0.6 * rim), 0.75 * highest));
    m_cornerText->setVisible(corner < rim && highest > 0.0);
    m_plot->graph(Corner)->setVisible(corner < rim && highest > 0.0);
    m_plot->xAxis->setRange(0.0, rim * kBeyondRim);
    m_plot->yAxis->setRange(0.0, highest > 0.0 ? highest * kHeadroom : 1.0);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace hitscope
