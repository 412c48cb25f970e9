// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/cost_view.h"

#include <algorithm>
#include <utility>

#include "models/quantity_text.h"
#include "panels/frame_rate/pipeline_colour.h"
#include "panels/plot/custom_plot.h"
#include "panels/plot/plot_theme.h"
#include "session/frame_costs.h"
#include "session/shown_number.h"
#include "ui_cost_view.h"

namespace hitscope {

namespace {

constexpr std::uint64_t kGpuIsLate = 12;  // frames: what the GPU has not told by then it never will

QString nameOf(PipelineKind pipeline) {
    return QString::fromUtf8(pipelineTraits(pipeline).name);
}

}  // namespace

CostView::CostView(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_ui(std::make_unique<Ui::CostView>()) {
    m_ui->setupUi(this);
    QCustomPlot* plot = m_ui->plot;
    plot->setBufferDevicePixelRatio(plot->devicePixelRatioF());
    plot->xAxis->setLabel(tr("hits"));
    plot->xAxis->setLabelPadding(1);
    plot->yAxis->setLabel(tr("ms"));
    plot->yAxis->setLabelPadding(1);
    plot->yAxis->ticker()->setTickCount(4);
    plot->axisRect()->setMinimumMargins(QMargins(4, 6, 8, 0));
    for (Curves& curves : m_curves) {
        curves = {plot->addGraph(), plot->addGraph()};
    }
    m_crossover = new QCPItemStraightLine(plot);
    m_ui->progress->hide();
    connect(m_ui->measure, &QPushButton::clicked, this, &CostView::measureOrCancel);
    connect(&m_measurement, &CostMeasurement::progressed, this, [this](int done, int total) {
        m_ui->progress->setRange(0, total);
        m_ui->progress->setValue(done);
        m_showsMeasured = true;
        m_isDue = true;
        refresh();
    });
    connect(&m_measurement, &CostMeasurement::finished, this, &CostView::followMeasurement);
    connect(&m_measurement, &CostMeasurement::failed, this, [this](const QString& why) { say(why); });
    connect(&session, &Session::sceneReplaced, this, &CostView::followScene);
    connect(&session, &Session::targetAdded, this, &CostView::followScene);
    connect(&session, &Session::targetRemoved, this, &CostView::followScene);
    applyPalette();
}

CostView::~CostView() = default;

void CostView::applyPalette() {
    applyPlotTheme(*m_ui->plot, *this);
    for (std::size_t i = 0; i < kPipelines.size(); ++i) {
        const QColor colour = pipelineColour(kPipelines[i]);
        m_curves[i].frame->setPen(QPen(colour, 1.5));
        m_curves[i].hit->setPen(QPen(colour, 1.5, Qt::DashLine));
        for (QCPGraph* graph : {m_curves[i].frame, m_curves[i].hit}) {
            graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, 4));
        }
    }
    m_crossover->setPen(QPen(palette().color(QPalette::WindowText), 1, Qt::DotLine));
    const auto swatch = [](PipelineKind kind) {
        return QStringLiteral("<font color=\"%1\">■</font> %2")
            .arg(pipelineColour(kind).name(), nameOf(kind));
    };
    QStringList swatches;
    for (const PipelineKind pipeline : kPipelines) {
        swatches << swatch(pipeline);
    }
    m_ui->legend->setText(tr("%1  (– frame, -- hit)").arg(swatches.join(QStringLiteral("  "))));
    m_isDue = true;
    refresh();
}

void CostView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if ((event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) &&
        m_crossover != nullptr) {
        applyPalette();
    }
}

void CostView::measureOrCancel() {
    if (m_measurement.isRunning()) {
        m_measurement.cancel();
        return;
    }
    CostPlan plan = m_plan;
    std::erase_if(plan.pipelines,
                  [this](PipelineKind kind) { return !m_session.whyUnavailable(kind).isEmpty(); });
    std::size_t vertices = 0;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        vertices += target->visible ? target->deformed.original().vertexCount() : 0;
    }
    m_measuredOn = tr("%1, %2 vertices").arg(m_session.sceneName(), countText(vertices));
    m_isOfThisScene = true;
    m_measurement.start(m_session, m_camera ? m_camera() : Camera(), std::move(plan));
    m_ui->progress->setRange(0, 0);
    followMeasurement();
}

void CostView::followMeasurement() {
    const bool running = m_measurement.isRunning();
    m_ui->measure->setText(running ? tr("Cancel") : tr("Measure now"));
    m_ui->progress->setVisible(running);
}

void CostView::say(const QString& text) {
    m_ui->words->setText(text);
    m_ui->words->setToolTip(text);
}

/// What was measured stays, and says of which scene it is; what is collected is of one scene only.
void CostView::followScene() {
    m_isOfThisScene = false;
    m_collected.clear();
    m_leftOut = false;
    m_nextToCollect = m_session.frameCosts().nextFrame();
    m_isDue = true;
    refresh();
}

void CostView::clear() {
    m_measurement.cancel();
    m_collected.clear();
    m_leftOut = false;
    m_showsMeasured = false;
    m_nextToCollect = m_session.frameCosts().nextFrame();
    m_isDue = true;
    refresh();
}

void CostView::collect() {
    const FrameCosts& costs = m_session.frameCosts();
    const Ring<FrameCost>& frames = costs.frames();
    std::size_t first = frames.size();
    while (first > 0 && frames[first - 1].number >= m_nextToCollect) {
        --first;
    }
    for (std::size_t i = first; i < frames.size(); ++i) {
        const FrameCost& frame = frames[i];
        if (costs.measuresGpu().value_or(false) && !frame.gpu &&
            frame.number + kGpuIsLate > costs.nextFrame()) {
            return;  // its time is on the way
        }
        m_nextToCollect = frame.number + 1;
        if (frame.pipelines > 1) {
            m_leftOut = true;  // what two cost together is what neither costs
            continue;
        }
        const double gpu = frame.gpu.value_or(0.0);
        if (frame.hits == 0) {
            m_collected.addFrame(frame.pipeline, frame.history, std::max(frame.cpu - frame.physics, gpu));
        } else {
            m_collected.addHit(
                frame.pipeline, frame.history,
                (frame.deformation + frame.gpuDeformation.value_or(0.0)) / static_cast<double>(frame.hits));
        }
        m_isDue = m_isDue || !m_showsMeasured;
    }
}

const CostCurves& CostView::shown() const {
    return m_showsMeasured ? m_measurement.curves() : m_collected;
}

std::vector<NamedCurve> CostView::curves() const {
    std::vector<NamedCurve> curves;
    curves.reserve(std::size(kPipelines));
    for (const PipelineKind pipeline : kPipelines) {
        curves.push_back({pipeline, shown().points(pipeline)});
    }
    return curves;
}

void CostView::refresh() {
    collect();
    if (m_isDue && isVisible()) {
        m_isDue = false;
        draw();
    }
}

void CostView::draw() {
    double mostHits = 0.0;
    double mostTime = 0.0;
    for (std::size_t i = 0; i < kPipelines.size(); ++i) {
        m_curves[i].frame->data()->clear();
        m_curves[i].hit->data()->clear();
        for (const CostPoint& point : shown().points(kPipelines[i])) {
            mostHits = std::max(mostHits, point.hits);
            const auto add = [&](QCPGraph& graph, std::optional<double> seconds) {
                if (seconds) {
                    graph.addData(point.hits, *seconds * kMilliseconds);
                    mostTime = std::max(mostTime, *seconds * kMilliseconds);
                }
            };
            add(*m_curves[i].frame, point.frame);
            add(*m_curves[i].hit, point.hit);
        }
    }
    m_ui->plot->xAxis->setRange(0.0, std::max(mostHits * 1.05, 10.0));
    m_ui->plot->yAxis->setRange(0.0, std::max(mostTime * 1.15, 1.0e-3));
    drawCrossover(*m_crossover, crossoverOf(CostOf::FrameWithHit));
    say(inWords());
    m_ui->plot->replot(QCustomPlot::rpQueuedReplot);
}

void CostView::drawCrossover(QCPItemStraightLine& line, std::optional<double> hits) {
    line.setVisible(hits.has_value());
    line.point1->setCoords(hits.value_or(0.0), 0.0);
    line.point2->setCoords(hits.value_or(0.0), 1.0);
}

std::optional<double> CostView::crossoverOf(CostOf what) const {
    return crossover(shown().points(PipelineKind::UniformArray),
                     shown().points(PipelineKind::TransformFeedback), what);
}

QString CostView::inWords() const {
    const std::optional<double> still = crossoverOf(CostOf::Frame);
    const std::optional<double> hit = crossoverOf(CostOf::FrameWithHit);
    QString source = m_showsMeasured ? tr("Measured on %1.").arg(m_measuredOn)
                                     : tr("Collected as you work with each pipeline.");
    if (m_showsMeasured && !m_isOfThisScene) {
        source += u' ' + tr("The scene has changed since.");
    } else if (!m_showsMeasured && m_leftOut) {
        source += u' ' + tr("Frames of two pipelines are left out.");
    }
    if (!still && !hit) {
        return source + u' ' + tr("No crossover yet.");
    }
    const auto from = [](std::optional<double> hits) {
        return hits ? tr("from %1 hits").arg(shownNumber(*hits, 'f', 0)) : tr("nowhere yet");
    };
    return source + u' ' +
           tr("Crossover, where uniform arrays cost more: %1 in a frame, %2 in a frame that takes a hit.")
               .arg(from(still), from(hit));
}

}  // namespace hitscope
