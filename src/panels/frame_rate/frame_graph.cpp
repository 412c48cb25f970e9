// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/frame_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "models/quantity_text.h"
#include "panels/frame_rate/pipeline_colour.h"
#include "panels/plot/custom_plot.h"
#include "panels/plot/plot_theme.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr double kScrollsOn = 1.0;  // seconds after the last frame
constexpr double kGap = 0.5;        // seconds without a frame that break the line
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 2> kTargets = {60.0, 30.0};  // frames a second

/// What has no pipeline's colour.
constexpr std::array<QRgb, FrameGraph::CurveCount> kColours = {0,          0xff2e9e5b, 0xffd1477a,
                                                               0xff1a9aa0, 0xffc0392b, 0xff9a7b4f};

/// Says the unit at each number: an axis label would take a row of a low dock.
class SecondsTicker : public QCPAxisTicker {
protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
        return FrameGraph::tr("%1 s").arg(QCPAxisTicker::getTickLabel(tick, locale, format, precision));
    }
};

std::optional<double> secondsOf(const FrameCost& frame, FrameGraph::Curve curve) {
    switch (curve) {
        case FrameGraph::Cpu:
            return frame.cpu;
        case FrameGraph::Gpu:
            return frame.gpu;
        case FrameGraph::Physics:
            return frame.physics;
        case FrameGraph::Deformation:
            return frame.deformation + frame.gpuDeformation.value_or(0.0);
        case FrameGraph::ReadBack:
            return frame.readBack;
        default:
            return frame.total;
    }
}

}  // namespace

FrameGraph::FrameGraph(QCustomPlot& plot, const FrameCosts& costs, QObject* parent)
    : QObject(parent), m_plot(plot), m_costs(costs) {
    m_plot.setBufferDevicePixelRatio(m_plot.devicePixelRatioF());
    m_plot.setPlottingHint(QCP::phFastPolylines);
    m_plot.setFocusPolicy(Qt::StrongFocus);
    m_plot.setMouseTracking(true);
    m_plot.installEventFilter(this);
    m_plot.xAxis->setTicker(QSharedPointer<SecondsTicker>::create());
    m_plot.yAxis->ticker()->setTickCount(4);
    m_plot.axisRect()->setMinimumMargins(QMargins(4, 6, 8, 0));
    makeCurves();
    makeTargetLines();
    m_pointer = new QCPItemStraightLine(&m_plot);
    m_pointer->setVisible(false);
    applyPalette();
}

void FrameGraph::makeCurves() {
    for (std::size_t i = 0; i < allPipelines().size(); ++i) {
        m_frameCurves.push_back(m_plot.addGraph());
    }
    for (int curve = Cpu; curve < CurveCount; ++curve) {
        m_curves[curve] = m_plot.addGraph();
        m_curves[curve]->setPen(QPen(QColor(kColours[static_cast<std::size_t>(curve)]), 1));
    }
    m_hits = m_plot.addGraph();
    m_hits->setLineStyle(QCPGraph::lsNone);
}

void FrameGraph::makeTargetLines() {
    for (const double target : kTargets) {
        auto* line = new QCPItemStraightLine(&m_plot);
        m_targetLines.push_back(line);
        auto* text = new QCPItemText(&m_plot);
        text->setText(shownNumber(target));
        text->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
        text->position->setTypeY(QCPItemPosition::ptPlotCoords);
        text->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
        m_targetTexts.push_back(text);
    }
    setPerSecond(false);
}

void FrameGraph::applyPalette() {
    applyPlotTheme(m_plot, m_plot);
    QColor ink = m_plot.palette().color(QPalette::WindowText);
    m_hits->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangle, QPen(ink, 1), QBrush(ink), 6));
    m_pointer->setPen(QPen(ink, 1));
    for (std::size_t i = 0; i < m_frameCurves.size(); ++i) {
        QColor colour = pipelineColour(allPipelines()[i].kind);
        m_frameCurves[i]->setPen(QPen(colour, 1));
        colour.setAlphaF(0.2f);
        m_frameCurves[i]->setBrush(colour);
    }
    ink.setAlphaF(0.5f);
    for (std::size_t i = 0; i < m_targetLines.size(); ++i) {
        m_targetLines[i]->setPen(QPen(ink, 1, Qt::DashLine));
        m_targetTexts[i]->setColor(ink);
        m_targetTexts[i]->setFont(m_plot.font());
    }
    redraw();
}

QColor FrameGraph::colour(Curve curve) const {
    if (curve != Frame) {
        return QColor(kColours[static_cast<std::size_t>(curve)]);
    }
    return pipelineColour(frameCount() > 0 ? frame(frameCount() - 1).pipeline
                                           : PipelineKind::TransformFeedback);
}

void FrameGraph::setCurveShown(Curve curve, bool shown) {
    m_shown[curve] = shown;
    redraw();
}

void FrameGraph::setPerSecond(bool perSecond) {
    m_perSecond = perSecond;
    for (std::size_t i = 0; i < kTargets.size(); ++i) {
        const double at = perSecond ? kTargets[i] : kMilliseconds / kTargets[i];
        m_targetLines[i]->point1->setCoords(0.0, at);
        m_targetLines[i]->point2->setCoords(1.0, at);
        m_targetTexts[i]->position->setCoords(1.0, at);
    }
    redraw();
}

void FrameGraph::setPaused(bool paused) {
    if (paused == m_paused) {
        return;
    }
    if (paused) {
        m_frozen = frames();
        m_pausedAt = m_costs.now();
    } else {
        m_frozen.clear();
        m_back = 0.0;
    }
    m_paused = paused;
    redraw();
    Q_EMIT pausedChanged(paused);
}

void FrameGraph::clear() {
    m_firstShown = m_costs.nextFrame();
    m_frozen.clear();
    endHover();
    redraw();
}

std::size_t FrameGraph::frameCount() const {
    return m_paused ? m_frozen.size() : m_costs.frames().size();
}

const FrameCost& FrameGraph::frame(std::size_t index) const {
    return m_paused ? m_frozen[index] : m_costs.frames()[index];
}

/// Frames are in the order of their ends, so it is found by halving.
std::size_t FrameGraph::firstFrameEndingAfter(double time) const {
    std::size_t first = 0;
    std::size_t count = frameCount();
    while (count > 0) {
        const std::size_t half = count / 2;
        if (frame(first + half).end <= time || frame(first + half).number < m_firstShown) {
            first += half + 1;
            count -= half + 1;
        } else {
            count = half;
        }
    }
    return first;
}

std::vector<FrameCost> FrameGraph::frames() const {
    std::vector<FrameCost> all;
    for (std::size_t i = firstFrameEndingAfter(-1.0); i < frameCount(); ++i) {
        all.push_back(frame(i));
    }
    return all;
}

void FrameGraph::redraw() {
    m_isDue = true;
    refresh();
}

/// The right edge, seconds by FrameCosts::now().
double FrameGraph::present() const {
    if (m_paused) {
        return m_pausedAt;
    }
    const double last = frameCount() > 0 ? frame(frameCount() - 1).end : 0.0;
    return std::min(m_costs.now(), last + kScrollsOn);
}

bool FrameGraph::isMoving() const {
    // And a little longer, so that the last picture is that of where it comes to rest.
    return !m_paused && frameCount() > 0 && m_costs.now() < frame(frameCount() - 1).end + kScrollsOn + 0.5;
}

void FrameGraph::refresh() {
    if (!m_plot.isVisible() || !(m_isDue || isMoving())) {
        return;
    }
    m_isDue = false;
    fill();
    if (m_mouse) {
        hover(*m_mouse);
    }
    m_plot.replot(QCustomPlot::rpQueuedRefresh);  // with what else is new in the window
    Q_EMIT drawn();
}

void FrameGraph::fill() {
    for (int i = 0; i < m_plot.graphCount(); ++i) {
        m_plot.graph(i)->data()->clear();
    }
    const double now = present();
    const double last = now - m_back;
    double highest = 0.0;
    double before = -std::numeric_limits<double>::infinity();
    // One more on either side, so that lines reach the edges.
    const std::size_t first = firstFrameEndingAfter(last - m_seconds);
    for (std::size_t i = first > 0 ? first - 1 : 0; i < frameCount(); ++i) {
        const FrameCost& cost = frame(i);
        if (cost.number < m_firstShown || cost.total <= 0.0) {
            continue;
        }
        if (cost.end - cost.total - before > kGap) {
            for (int graph = 0; graph < m_plot.graphCount(); ++graph) {
                m_plot.graph(graph)->addData(before - now, kNothing);
            }
            FrameCost begin = cost;  // so that a frame that stands alone is a line, too
            begin.hits = 0;
            fillFrame(begin, cost.end - cost.total - now, highest);
        }
        before = cost.end;
        fillFrame(cost, cost.end - now, highest);
        if (cost.end > last) {
            break;
        }
    }
    m_plot.xAxis->setRange(-m_back - m_seconds, -m_back);
    fitRange(highest);
}

void FrameGraph::fillFrame(const FrameCost& cost, double key, double& highest) {
    if (m_shown[Frame]) {
        const double value = m_perSecond ? 1.0 / cost.total : cost.total * kMilliseconds;
        for (std::size_t i = 0; i < m_frameCurves.size(); ++i) {
            // The curve goes on to where another pipeline takes over, and is broken from there on.
            QCPGraphDataContainer& data = *m_frameCurves[i]->data();
            const bool isItsOwn = allPipelines()[i].kind == cost.pipeline;
            const bool ends = !data.isEmpty() && !std::isnan((data.constEnd() - 1)->value);
            if (isItsOwn) {
                data.add(QCPGraphData(key, value));
            } else if (ends) {
                data.add(QCPGraphData(key, kNothing));
            }
        }
        highest = std::max(highest, value);
    }
    for (int i = Cpu; i < CurveCount && !m_perSecond; ++i) {
        const std::optional<double> seconds = secondsOf(cost, static_cast<Curve>(i));
        if (m_shown[i] && seconds) {
            m_curves[i]->data()->add(QCPGraphData(key, *seconds * kMilliseconds));
            highest = std::max(highest, *seconds * kMilliseconds);
        }
    }
    if (cost.hits > 0) {
        m_hits->data()->add(QCPGraphData(key, 0.0));
    }
}

void FrameGraph::fitRange(double highest) {
    const double least = m_perSecond ? 66.0 : 20.0;  // the line at 60 is always in sight
    m_plot.yAxis->setRange(0.0, std::max(least, highest * 1.15));
    for (std::size_t i = 0; i < m_targetTexts.size(); ++i) {
        const double along = m_targetLines[i]->point1->value() / m_plot.yAxis->range().upper;
        m_targetLines[i]->setVisible(along > 0.06);
        m_targetTexts[i]->setVisible(along > 0.15 && along < 0.93);
    }
}

QString FrameGraph::describe(const FrameCost& cost) const {
    const auto ms = [](double seconds) {
        return tr("%1 ms").arg(shownNumber(seconds * kMilliseconds, 'f', 2));
    };
    const auto orUnknown = [&ms](std::optional<double> seconds) { return seconds ? ms(*seconds) : tr("–"); };
    const std::string_view name = pipelineTraits(cost.pipeline).name;
    QStringList lines{
        tr("Frame %1: %2").arg(cost.number).arg(ms(cost.total)),
        tr("CPU %1, GPU %2").arg(ms(cost.cpu), orUnknown(cost.gpu)),
        tr("Physics %1").arg(ms(cost.physics)),
        tr("Deformation: CPU %1, GPU %2").arg(ms(cost.deformation), orUnknown(cost.gpuDeformation)),
        tr("Read-back and normals %1").arg(ms(cost.readBack)),
        tr("%1, hits so far: %2").arg(QString::fromUtf8(name)).arg(cost.history)};
    if (cost.hits > 0) {
        lines.append(tr("Hits that arrived: %1").arg(cost.hits));
    }
    return lines.join(u'\n');
}

}  // namespace hitscope
