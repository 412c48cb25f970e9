// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/cost_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "models/plain_text.h"
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

CostView::CostView(Session& session, const CostMeter& meter, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_ui(std::make_unique<Ui::CostView>()),
      m_measurement(meter),
      m_bySize(meter) {
    m_ui->setupUi(this);
    QCustomPlot* plot = m_ui->plot;
    plot->setBufferDevicePixelRatio(plot->devicePixelRatioF());
    plot->xAxis->setLabelPadding(1);
    plot->yAxis->setLabel(tr("ms"));
    plot->yAxis->setLabelPadding(1);
    plot->axisRect()->setMinimumMargins(QMargins(4, 6, 8, 0));
    for (const PipelineKind pipeline : pipelinesPapersFirst()) {
        m_curves.push_back({pipeline, plot->addGraph(), plot->addGraph()});
    }
    m_crossover = new QCPItemStraightLine(plot);
    m_ui->progress->hide();
    connect(m_ui->measure, &QPushButton::clicked, this, &CostView::measureOrCancel);
    connect(m_ui->axis, &QComboBox::currentIndexChanged, this, &CostView::followAxis);
    connect(&m_measurement, &CostMeasurement::progressed, this, [this] { m_showsMeasured = true; });
    follow(m_measurement);
    follow(m_bySize);
    connect(&session, &Session::sceneReplaced, this, &CostView::followScene);
    connect(&session.targets(), &SessionTargets::added, this, &CostView::followScene);
    connect(&session.targets(), &SessionTargets::removed, this, &CostView::followScene);
    followAxis();
    applyPalette();
}

CostView::~CostView() = default;

void CostView::follow(CostMeasurement& measurement) {
    connect(&measurement, &CostMeasurement::progressed, this, [this](int done, int total) {
        m_ui->progress->setRange(0, total);
        m_ui->progress->setValue(done);
        m_isDue = true;
        refresh();
    });
    connect(&measurement, &CostMeasurement::finished, this, &CostView::followMeasurement);
    connect(&measurement, &CostMeasurement::failed, this, [this](const QString& why) { say(why); });
}

CostAxis CostView::axis() const {
    return m_ui->axis->currentIndex() == 1 ? CostAxis::Vertices : CostAxis::Hits;
}

void CostView::followAxis() {
    const bool byHits = axis() == CostAxis::Hits;
    QCPAxis* horizontal = m_ui->plot->xAxis;
    QCPAxis* vertical = m_ui->plot->yAxis;
    horizontal->setLabel(byHits ? tr("hits") : tr("vertices"));
    const auto scale = byHits ? QCPAxis::stLinear : QCPAxis::stLogarithmic;
    for (QCPAxis* each : {horizontal, vertical}) {
        each->setScaleType(scale);
        each->setTicker(byHits ? QSharedPointer<QCPAxisTicker>::create()
                               : QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog));
    }
    vertical->ticker()->setTickCount(4);
    m_ui->measure->setToolTip(
        byHits
            ? tr("Measures every pipeline that runs here on this scene in the background, up to 600 hits. "
                 "The scene and its hits stay as they are.")
            : tr("Measures every pipeline that runs here in the background, on spheres of 1,000 to 1,000,000 "
                 "vertices. The scene and its hits stay as they are."));
    m_isDue = true;
    refresh();
}

void CostView::applyPalette() {
    applyPlotTheme(*m_ui->plot, *this);
    for (const Curves& curves : m_curves) {
        const QColor colour = pipelineColour(curves.pipeline);
        curves.frame->setPen(QPen(colour, 1.5));
        curves.hit->setPen(QPen(colour, 1.5, Qt::DashLine));
        for (QCPGraph* graph : {curves.frame, curves.hit}) {
            graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, 4));
        }
    }
    m_crossover->setPen(QPen(palette().color(QPalette::WindowText), 1, Qt::DotLine));
    const auto swatch = [](PipelineKind kind) {
        return QStringLiteral("<font color=\"%1\">■</font> %2")
            .arg(pipelineColour(kind).name(), nameOf(kind));
    };
    QStringList swatches;
    for (const Curves& curves : m_curves) {
        swatches << swatch(curves.pipeline);
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
    if (isMeasuring()) {
        m_measurement.cancel();
        m_bySize.cancel();
        return;
    }
    if (axis() == CostAxis::Hits) {
        measureScene();
    } else {
        measureSizes();
    }
    m_ui->progress->setRange(0, 0);
    followMeasurement();
}

void CostView::measureSizes() {
    SizePlan plan = m_sizePlan;
    std::erase_if(plan.pipelines,
                  [this](PipelineKind kind) { return !m_session.readBack().whyUnavailable(kind).isEmpty(); });
    m_bySize.start(std::move(plan));
}

void CostView::measureScene() {
    CostPlan plan = m_plan;
    std::erase_if(plan.pipelines,
                  [this](PipelineKind kind) { return !m_session.readBack().whyUnavailable(kind).isEmpty(); });
    std::size_t vertices = 0;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        vertices += target->visible ? target->deformed.original().vertexCount() : 0;
    }
    m_measuredOn = tr("%1, %Ln {vertex|vertices}", nullptr, trCount(vertices)).arg(m_session.sceneName());
    m_isOfThisScene = true;
    m_measurement.start(m_session, m_camera ? m_camera() : Camera(), std::move(plan));
}

void CostView::followMeasurement() {
    const bool running = isMeasuring();
    m_ui->measure->setText(running ? tr("Cancel") : tr("Measure now"));
    m_ui->progress->setVisible(running);
}

void CostView::say(const QString& text) {
    m_ui->words->setText(text);
    m_ui->words->setToolTip(asPlainText(text));
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
    m_bySize.cancel();
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
    if (axis() == CostAxis::Vertices) {
        return m_bySize.curves();
    }
    return m_showsMeasured ? m_measurement.curves() : m_collected;
}

std::vector<NamedCurve> CostView::curves() const {
    std::vector<NamedCurve> named;
    named.reserve(m_curves.size());
    for (const Curves& curves : m_curves) {
        named.push_back({curves.pipeline, shown().points(curves.pipeline)});
    }
    return named;
}

void CostView::refresh() {
    collect();
    if (m_isDue && isVisible()) {
        m_isDue = false;
        draw();
    }
}

void CostView::draw() {
    double most = 0.0;
    double mostTime = 0.0;
    double leastTime = std::numeric_limits<double>::infinity();
    for (const Curves& curves : m_curves) {
        curves.frame->data()->clear();
        curves.hit->data()->clear();
        for (const CostPoint& point : shown().points(curves.pipeline)) {
            most = std::max(most, point.at);
            const auto add = [&](QCPGraph& graph, std::optional<double> seconds) {
                if (seconds) {
                    graph.addData(point.at, *seconds * kMilliseconds);
                    mostTime = std::max(mostTime, *seconds * kMilliseconds);
                    leastTime = std::min(leastTime, *seconds * kMilliseconds);
                }
            };
            add(*curves.frame, point.frame);
            add(*curves.hit, point.hit);
        }
    }
    drawAxes(most, mostTime, std::min(leastTime, mostTime));
    drawCrossover(*m_crossover, crossoverOf(CostOf::FrameWithHit));
    say(inWords());
    m_ui->plot->replot(QCustomPlot::rpQueuedReplot);
}

void CostView::drawAxes(double most, double mostTime, double leastTime) {
    if (axis() == CostAxis::Hits) {
        m_ui->plot->xAxis->setRange(0.0, std::max(most * 1.05, 10.0));
        m_ui->plot->yAxis->setRange(0.0, std::max(mostTime * 1.15, 1.0e-3));
        return;
    }
    constexpr double kFewestVertices = 500.0;
    constexpr double kMostVertices = 2.0e6;
    m_ui->plot->xAxis->setRange(kFewestVertices, kMostVertices);
    m_ui->plot->yAxis->setRange(leastTime > 0.0 ? 0.5 * leastTime : 0.01,
                                mostTime > 0.0 ? 2.0 * mostTime : 1000.0);
}

void CostView::drawCrossover(QCPItemStraightLine& line, std::optional<double> at) {
    line.setVisible(at.has_value());
    line.point1->setCoords(at.value_or(0.0), 0.0);
    line.point2->setCoords(at.value_or(0.0), 1.0);
}

std::optional<double> CostView::crossoverOf(CostOf what) const {
    return crossover(shown().points(PipelineKind::UniformArray),
                     shown().points(PipelineKind::TransformFeedback), what);
}

QString CostView::sourceInWords() const {
    if (axis() == CostAxis::Vertices) {
        return m_bySize.curves().isEmpty()
                   ? tr("Not measured yet: spheres of 1,000 to 1,000,000 vertices with %1 hits.")
                         .arg(shownCount(m_sizePlan.hits))
                   : tr("Measured on spheres with %1 hits.").arg(shownCount(m_sizePlan.hits));
    }
    QString source = m_showsMeasured ? tr("Measured on %1.").arg(m_measuredOn)
                                     : tr("Collected as you work with each pipeline.");
    if (m_showsMeasured && !m_isOfThisScene) {
        source += u' ' + tr("The scene has changed since.");
    } else if (!m_showsMeasured && m_leftOut) {
        source += u' ' + tr("Frames of two pipelines are left out.");
    }
    return source;
}

QString CostView::inWords() const {
    const std::optional<double> still = crossoverOf(CostOf::Frame);
    const std::optional<double> hit = crossoverOf(CostOf::FrameWithHit);
    const QString source = sourceInWords();
    if (!still && !hit) {
        const bool isEmpty = axis() == CostAxis::Vertices && m_bySize.curves().isEmpty();
        return isEmpty ? source : source + u' ' + tr("No crossover yet.");
    }
    const auto from = [this](std::optional<double> at) {
        if (!at) {
            return tr("nowhere yet");
        }
        const int number = trCount(static_cast<std::size_t>(std::llround(*at)));
        return axis() == CostAxis::Hits ? tr("from %Ln {hit|hits}", nullptr, number)
                                        : tr("from %Ln {vertex|vertices}", nullptr, number);
    };
    return source + u' ' +
           tr("Crossover, where uniform arrays cost more: %1 in a frame, %2 in a frame that takes a hit.")
               .arg(from(still), from(hit));
}

}  // namespace hitscope
