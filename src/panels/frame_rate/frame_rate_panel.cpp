// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/frame_rate_panel.h"

#include <QAction>
#include <QEvent>
#include <algorithm>
#include <limits>

#include "ui_frame_rate.h"

namespace hitscope {

namespace {

constexpr double kWindow = 10.0;       // seconds that the graph shows
constexpr double kGap = 0.5;           // seconds without a frame that break the line
constexpr int kRefreshInterval = 100;  // milliseconds
constexpr double kMilliseconds = 1000.0;

QString milliseconds(double seconds) {
    return FrameRatePanel::tr("%1 ms").arg(seconds * kMilliseconds, 0, 'f', seconds < 0.0995 ? 1 : 0);
}

}  // namespace

FrameRatePanel::FrameRatePanel(QAction& continuous, QWidget* parent)
    : QWidget(parent), m_ui(std::make_unique<Ui::FrameRate>()) {
    m_ui->setupUi(this);
    m_ui->continuous->setDefaultAction(&continuous);
    m_clock.start();
    m_timer.setInterval(kRefreshInterval);
    makePlot();
    connect(&m_timer, &QTimer::timeout, this, &FrameRatePanel::refresh);
    connect(m_ui->clear, &QToolButton::clicked, this, &FrameRatePanel::clear);
    connect(m_ui->quantity, &QComboBox::currentIndexChanged, this, [this] {
        m_lastRefresh = -1.0;
        refresh();
    });
}

FrameRatePanel::~FrameRatePanel() = default;

double FrameRatePanel::now() const {
    return static_cast<double>(m_clock.nsecsElapsed()) * 1.0e-9;
}

void FrameRatePanel::addFrame(double seconds) {
    m_frames.add(now(), seconds);
}

void FrameRatePanel::clear() {
    m_frames.clear();
    m_lastRefresh = -1.0;
    refresh();
}

FrameTimes::Summary FrameRatePanel::summary() const {
    return m_frames.summary(now());
}

void FrameRatePanel::makePlot() {
    QCustomPlot* plot = m_ui->plot;
    plot->addGraph();
    plot->graph()->setLineStyle(QCPGraph::lsLine);
    plot->xAxis->setRange(-kWindow, 0.0);
    plot->xAxis->setLabel(tr("seconds"));
    plot->xAxis->setLabelPadding(1);
    plot->yAxis->ticker()->setTickCount(4);
    plot->axisRect()->setMinimumMargins(QMargins(4, 6, 8, 0));
    plot->setBufferDevicePixelRatio(devicePixelRatioF());
    applyPalette();
}

void FrameRatePanel::applyPalette() {
    QCustomPlot* plot = m_ui->plot;
    const QColor ink = palette().color(QPalette::WindowText);
    QColor faint = ink;
    faint.setAlphaF(0.15f);
    QColor dim = ink;
    dim.setAlphaF(0.6f);
    plot->setBackground(palette().brush(QPalette::Base));
    for (QCPAxis* axis : {plot->xAxis, plot->yAxis}) {
        axis->setBasePen(QPen(dim, 1));
        axis->setTickPen(QPen(dim, 1));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(ink);
        axis->setLabelColor(dim);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->grid()->setPen(QPen(faint, 1));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
    const QColor line = palette().color(QPalette::Highlight);
    QColor area = line;
    area.setAlphaF(0.25f);
    plot->graph()->setPen(QPen(line, 1.5));
    plot->graph()->setBrush(area);
    m_lastRefresh = -1.0;
}

void FrameRatePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        applyPalette();
    }
}

void FrameRatePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_timer.start();
}

void FrameRatePanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_timer.stop();
}

void FrameRatePanel::refresh() {
    // Once the last frame has left the graph there is nothing to move until the next one comes.
    const std::vector<FrameTimes::Sample> samples = m_frames.samples();
    const double newest = samples.empty() ? -kWindow : samples.back().end;
    if (m_lastRefresh >= 0.0 && newest < m_lastRefresh - kWindow - 1.0) {
        return;
    }
    showReadOuts();
    plotSamples();
    m_lastRefresh = now();
}

void FrameRatePanel::plotSamples() {
    const bool perSecond = m_ui->quantity->currentIndex() == 1;
    const double present = now();
    QVector<double> when;
    QVector<double> values;
    double highest = 0.0;
    double before = -std::numeric_limits<double>::infinity();
    for (const FrameTimes::Sample& sample : m_frames.samples()) {
        const double age = sample.end - present;
        if (age < -kWindow - 1.0 || sample.cost <= 0.0) {
            continue;
        }
        if (sample.end - sample.cost - before > kGap && !when.isEmpty()) {
            when.append(age);
            values.append(std::numeric_limits<double>::quiet_NaN());
        }
        before = sample.end;
        when.append(age);
        values.append(perSecond ? 1.0 / sample.cost : sample.cost * kMilliseconds);
        highest = std::max(highest, values.back());
    }
    m_ui->plot->graph()->setData(when, values, true);
    m_ui->plot->yAxis->setRange(0.0, highest > 0.0 ? highest * 1.15 : (perSecond ? 60.0 : 20.0));
    m_ui->plot->replot(QCustomPlot::rpQueuedReplot);
}

void FrameRatePanel::showReadOuts() {
    const FrameTimes::Summary summary = this->summary();
    const bool any = m_frames.size() > 0;
    const auto rate = [](double value) { return QString::number(value, 'f', value < 99.5 ? 1 : 0); };
    const QString nothing = QStringLiteral("–");
    m_ui->framesPerSecond->setText(summary.framesPerSecond > 0.0 ? rate(summary.framesPerSecond)
                                                                 : tr("idle"));
    m_ui->mean->setText(any ? milliseconds(summary.meanCost) : nothing);
    m_ui->median->setText(any ? milliseconds(summary.medianCost) : nothing);
    m_ui->low->setText(any ? rate(summary.onePercentLow) : nothing);
    m_ui->worst->setText(any ? milliseconds(summary.worstCost) : nothing);
}

}  // namespace hitscope
