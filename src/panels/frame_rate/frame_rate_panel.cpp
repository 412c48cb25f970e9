// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/frame_rate/frame_rate_panel.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "io/staged_files.h"
#include "models/costs_csv.h"
#include "models/frame_rate_text.h"
#include "models/plain_text.h"
#include "models/quantity_text.h"
#include "panels/fields/save_name.h"
#include "panels/frame_rate/cost_view.h"
#include "panels/frame_rate/flow_layout.h"
#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"
#include "session/session.h"
#include "session/shown_number.h"
#include "ui_frame_rate.h"

namespace hitscope {

namespace {

constexpr int kRefreshInterval = 100;      // milliseconds
constexpr int kSlowRefreshInterval = 250;  // the same, where the window takes long to compose
constexpr int kIdleInterval = 500;         // after the last frame: the graph alone is new
constexpr double kSlowFrame = 1.0 / 30.0;  // seconds
constexpr int kLegendPadding = 21;         // pixels: swatch, gaps and frame

/// `widest`: what it usually shows, so that it does not move its neighbours.
QLabel* addReadOut(QWidget& row, const char* name, const QString& title, const QString& tip,
                   const QString& widest) {
    auto* pair = new QWidget(&row);
    pair->setToolTip(tip);
    auto* layout = new QVBoxLayout(pair);
    layout->setContentsMargins(0, 0, 4, 0);
    layout->setSpacing(0);
    auto* caption = new QLabel(title, pair);
    caption->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(caption);
    auto* value = new QLabel(QStringLiteral("–"), pair);
    value->setObjectName(QLatin1String(name));
    value->setMinimumWidth(value->fontMetrics().horizontalAdvance(widest));
    layout->addWidget(value);
    row.layout()->addWidget(pair);
    return value;
}

QIcon swatch(const QColor& colour, qreal pixelRatio) {
    constexpr int kSide = 8;
    QPixmap pixmap(QSize(kSide, kSide) * pixelRatio);
    pixmap.setDevicePixelRatio(pixelRatio);
    pixmap.fill(colour);
    return QIcon(pixmap);
}

}  // namespace

FrameRatePanel::FrameRatePanel(Session& session, QAction& continuous, const CostMeter& meter, QWidget* parent)
    : QWidget(parent), m_session(session), m_ui(std::make_unique<Ui::FrameRate>()) {
    m_ui->setupUi(this);
    m_graph = new FrameGraph(*m_ui->plot, session.frameCosts(), this);
    m_costView = new CostView(session, meter);
    m_ui->tabs->addTab(m_costView, tr("Cost"));
    m_ui->tabs->setTabToolTip(1, tr("What frames and hits cost against the number of hits, or of vertices"));
    makeReadOuts();
    makeLegend();
    makeButtons(continuous);
    m_timer.setInterval(kRefreshInterval);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (!m_isHeld()) {
            refresh();
        }
    });
    connect(m_ui->tabs, &QTabWidget::currentChanged, this, &FrameRatePanel::refresh);
    connect(&session.frameCosts(), &FrameCosts::frameEnded, this, [this] {
        const FrameCost& frame = m_session.frameCosts().frames().back();
        if (std::exchange(m_pipelines, frame.pipelines) != frame.pipelines) {
            m_frames.clear();  // what one and what two pipelines cost is not to be mixed
            m_alone.clear();
        }
        if (frame.follows) {
            m_frames.add(frame.end, frame.total);
        } else {
            m_alone.push_back(frame.number);
        }
        m_isNew = true;
        const int interval = frame.total > kSlowFrame ? kSlowRefreshInterval : kRefreshInterval;
        if (isVisible() && (!m_timer.isActive() || m_timer.interval() == kIdleInterval)) {
            m_timer.start(interval);
        }
    });
}

FrameRatePanel::~FrameRatePanel() = default;

void FrameRatePanel::makeReadOuts() {
    auto* layout = new FlowLayout(m_ui->readOuts);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    const QString usual = frameTimeText(0.0888);
    const auto add = [this, usual](const char* name, const QString& title, const QString& tip,
                                   const QString& widest = {}) {
        return addReadOut(*m_ui->readOuts, name, title, tip, widest.isEmpty() ? usual : widest);
    };
    const QString rate = QStringLiteral("99.9");
    const QString last = tr(" of the last 1,024 frames");
    m_readOuts.framesPerSecond =
        add("framesPerSecond", tr("FPS"), tr("Frames a second that the frame times of the last second allow"),
            rate);
    m_readOuts.mean = add("mean", tr("Mean"), tr("Mean frame time") + last);
    m_readOuts.median = add("median", tr("Median"), tr("Median frame time") + last);
    m_readOuts.low = add("low", tr("1 % low"), tr("Frames a second over the slowest hundredth") + last, rate);
    m_readOuts.percentile99 = add("percentile99", tr("99 %"), tr("99 % took that long or less,") + last);
    m_readOuts.worst = add("worst", tr("Worst"), tr("Longest") + last);
}

void FrameRatePanel::makeLegend() {
    auto* layout = new FlowLayout(m_ui->legend);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    QFont small = font();
    small.setPointSizeF(0.9 * small.pointSizeF());
    const std::array<std::array<QString, 2>, FrameGraph::CurveCount> texts = {
        {{tr("Frame"), tr("The whole frame, in the colour of the pipeline that drew it")},
         {tr("CPU"), tr("What the window's thread works on a frame")},
         {tr("GPU"), tr("What the GPU works on a frame, by timer queries")},
         {tr("Physics"), tr("Steps of the physics")},
         {tr("Deformation"), tr("Applying hits, CPU and GPU together")},
         {tr("Read-back"), tr("Taking back what the GPU has moved, and the normals around it")}}};
    for (std::size_t i = 0; i < m_legend.size(); ++i) {
        auto* button = new QToolButton(m_ui->legend);
        button->setObjectName(QStringLiteral("curve%1").arg(i));
        button->setText(texts[i][0]);
        button->setToolTip(texts[i][1]);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(true);
        button->setCheckable(true);
        button->setChecked(true);
        button->setIconSize({8, 8});
        button->setFont(small);
        // Closer than the style has it: a low dock is to be left to the graph.
        const QFontMetrics metrics(small);
        button->setFixedSize(metrics.horizontalAdvance(texts[i][0]) + kLegendPadding, metrics.height() + 4);
        layout->addWidget(button);
        connect(button, &QToolButton::toggled, this,
                [this, i](bool shown) { m_graph->setCurveShown(static_cast<FrameGraph::Curve>(i), shown); });
        m_legend[i] = button;
    }
    layout->addWidget(makeQuantity());
    colourLegend();
}

QComboBox* FrameRatePanel::makeQuantity() {
    m_quantity = new QComboBox;
    m_quantity->setObjectName(QStringLiteral("quantity"));
    m_quantity->addItems({tr("ms"), tr("FPS")});
    m_quantity->setToolTip(tr("Frame times, or frames a second"));
    connect(m_quantity, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_graph->setPerSecond(index == 1);
        for (std::size_t i = FrameGraph::Cpu; i < m_legend.size(); ++i) {
            enableIf(*m_legend[i], index == 0, tr("Parts of a frame are shown in milliseconds only."));
        }
    });
    return m_quantity;
}

void FrameRatePanel::colourLegend() {
    m_frameColour = m_graph->colour(FrameGraph::Frame);
    for (std::size_t i = 0; i < m_legend.size(); ++i) {
        m_legend[i]->setIcon(swatch(m_graph->colour(static_cast<FrameGraph::Curve>(i)), devicePixelRatioF()));
    }
}

void FrameRatePanel::makeButtons(QAction& continuous) {
    auto* corner = new QWidget(this);
    auto* layout = new QHBoxLayout(corner);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    const auto add = [&](const char* name, const QString& icon, const QString& tip) {
        auto* button = new QToolButton(corner);
        button->setObjectName(QLatin1String(name));
        button->setIcon(themedIcon(icon));
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        button->setAutoRaise(true);
        button->setIconSize({16, 16});
        layout->addWidget(button);
        return button;
    };
    m_pause = add("pause", QStringLiteral("pause"),
                  tr("Pause the graph. Wheel zooms, drag goes back, double click comes back to now"));
    m_pause->setCheckable(true);
    connect(m_pause, &QToolButton::toggled, m_graph, &FrameGraph::setPaused);
    connect(m_graph, &FrameGraph::pausedChanged, m_pause, &QToolButton::setChecked);
    auto* run = new QToolButton(corner);
    run->setObjectName(QStringLiteral("continuous"));
    run->setDefaultAction(&continuous);
    run->setAutoRaise(true);
    run->setIconSize({16, 16});
    run->setToolButtonStyle(Qt::ToolButtonIconOnly);
    layout->addWidget(run);
    connect(add("csv", QStringLiteral("export"), tr("Save as CSV")), &QToolButton::clicked, this,
            &FrameRatePanel::chooseCsv);
    connect(add("clear", QStringLiteral("remove"), tr("Forget what was measured so far")),
            &QToolButton::clicked, this, &FrameRatePanel::clear);
    m_ui->tabs->setCornerWidget(corner);
}

void FrameRatePanel::clear() {
    m_frames.clear();
    m_alone.clear();
    m_graph->clear();
    m_costView->clear();
    showReadOuts();
}

/// A frame that stands alone counts once the GPU has said how long it took: the CPU's part of it, a tenth of
/// the whole on a software renderer, would promise a thousand frames a second.
void FrameRatePanel::takeFramesAlone() {
    const FrameCosts& costs = m_session.frameCosts();
    const Ring<FrameCost>& frames = costs.frames();
    std::size_t next = frames.size();
    for (std::size_t waiting = m_alone.size(); waiting-- > 0;) {
        while (next > 0 && frames[next - 1].number > m_alone[waiting]) {
            --next;
        }
        const bool isKept = next > 0 && frames[next - 1].number == m_alone[waiting];
        if (isKept && !frames[next - 1].gpu && costs.measuresGpu().value_or(true)) {
            continue;  // not known yet
        }
        if (isKept) {
            const FrameCost& frame = frames[next - 1];
            m_frames.add(frame.end, std::max(frame.total, frame.gpu.value_or(0.0)));
        }
        m_alone.erase(m_alone.begin() + static_cast<std::ptrdiff_t>(waiting));
    }
}

FrameTimes::Summary FrameRatePanel::summary() {
    takeFramesAlone();
    return m_frames.summary(m_session.frameCosts().now());
}

Status FrameRatePanel::saveCsv(const QString& path) const {
    const bool ofFrames = m_ui->tabs->currentIndex() == 0;
    const QByteArray csv =
        ofFrames ? framesCsv(m_graph->frames()) : curvesCsv(m_costView->curves(), m_costView->axis());
    return writeWhole(path, {csv.constData(), static_cast<std::size_t>(csv.size())});
}

void FrameRatePanel::chooseCsv() {
    const QString path = askSaveName(this, {.title = tr("Save as CSV"),
                                            .suggested = QStringLiteral("frames.csv"),
                                            .filters = {tr("CSV (*.csv)")},
                                            .suffixes = {QStringLiteral("csv")}});
    if (path.isEmpty()) {
        return;
    }
    if (const Status status = saveCsv(path); !status) {
        QMessageBox::warning(this, tr("Save as CSV"),
                             asPlainText(QString::fromStdString(status.error().message())));
    }
}

QByteArray FrameRatePanel::saveState() const {
    QByteArray state(1, m_quantity->currentIndex() == 1 ? 'f' : 't');
    for (const QToolButton* curve : m_legend) {
        state += curve->isChecked() ? '1' : '0';
    }
    return state;
}

void FrameRatePanel::restoreState(const QByteArray& state) {
    if (state.size() != static_cast<qsizetype>(m_legend.size()) + 1) {
        return;
    }
    m_quantity->setCurrentIndex(state.front() == 'f' ? 1 : 0);
    for (std::size_t i = 0; i < m_legend.size(); ++i) {
        m_legend[i]->setChecked(state[static_cast<qsizetype>(i) + 1] == '1');
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
    if (m_ui->tabs->currentIndex() == 0) {
        m_graph->refresh();
        m_ui->noGpuTimes->setVisible(!m_session.frameCosts().measuresGpu().value_or(true));
        showReadOuts();
        if (m_graph->colour(FrameGraph::Frame) != m_frameColour) {
            colourLegend();
        }
    }
    m_costView->refresh();
    if (!m_graph->isMoving() && summary().recent == 0) {
        m_timer.stop();  // nothing more to show until the next frame
    } else if (!std::exchange(m_isNew, false)) {
        m_timer.setInterval(kIdleInterval);
    }
}

void FrameRatePanel::showReadOuts() {
    const FrameTimes::Summary summary = this->summary();
    const bool any = m_frames.size() > 0;
    const auto show = [any](QLabel& label, const QString& text) {
        label.setText(any ? text : QStringLiteral("–"));
    };
    const auto rate = [](double value) { return shownNumber(value, 'f', value < 99.5 ? 1 : 0); };
    m_readOuts.framesPerSecond->setText(summary.recent > 0 ? rate(summary.framesPerSecond) : tr("Idle"));
    show(*m_readOuts.mean, frameTimeText(summary.meanCost));
    show(*m_readOuts.median, frameTimeText(summary.medianCost));
    show(*m_readOuts.low, rate(summary.onePercentLow));
    show(*m_readOuts.percentile99, frameTimeText(summary.percentile99Cost));
    show(*m_readOuts.worst, frameTimeText(summary.worstCost));
}

}  // namespace hitscope
