// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/falloff_plot.h"

#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "deform/deform.h"
#include "panels/plot/custom_plot.h"
#include "panels/plot/plot_theme.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kSamples = 200;
constexpr double kBeyondRim = 1.25;  // of max_distance, shown
constexpr double kHeadroom = 1.35;   // over the largest magnitude, for the labels
constexpr double kPressRim = 1.15;   // of a press' radius: its shoulder is within
constexpr double kEditRoom = 0.25;   // of the cap, below a curve's lowest point
constexpr double kOrdinateSteps = 1000.0;
constexpr double kStep = 0.05;  // of an ordinate
constexpr double kFineStep = 0.01;

enum Graph { Curve, Beyond, Corner, Points, Chosen };

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
    setAccessibleName(tr("Fall-off"));
    m_plot->setMinimumSize(120, 100);
    nameUnit(Unit::Metres);
    m_plot->xAxis->setLabelPadding(1);
    m_plot->yAxis->setLabelPadding(1);
    m_plot->yAxis->ticker()->setTickCount(3);
    m_plot->axisRect()->setMinimumMargins(QMargins(4, 6, 8, 0));
    m_plot->setBufferDevicePixelRatio(devicePixelRatioF());
    for (int graph = Curve; graph <= Chosen; ++graph) {
        m_plot->addGraph();
    }
    for (const Graph graph : {Corner, Points, Chosen}) {
        m_plot->graph(graph)->setLineStyle(QCPGraph::lsNone);
    }
    makeItems();
    takeMouse();
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
    m_plot->graph(Points)->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, line, palette().color(QPalette::Base), 8));
    m_plot->graph(Chosen)->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, line, 10));
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
    m_stepText->setText(tr("step of %1 %2").arg(shownNumber(std::abs(step), 'g', 3), m_unit));
    m_stepText->position->setCoords(rim * kBeyondRim, above);
}

void FalloffPlot::nameUnit(Unit unit) {
    m_unitShown = unit;
    m_unit = unit == Unit::Metres ? tr("m") : tr("%");
    const QString of = unit == Unit::Metres ? m_unit : tr("% of target");
    m_plot->xAxis->setLabel(tr("distance from the hit point (%1)").arg(of));
    m_plot->yAxis->setLabel(tr("moved by (%1)").arg(m_unit));
}

bool FalloffPlot::isEditable() const {
    return m_form.profile == DentProfile::Curve && !m_form.presses();
}

double FalloffPlot::rim() const {
    return m_form.presses() ? static_cast<double>(m_form.radius) * kPressRim
                            : static_cast<double>(m_constants.maxDistance);
}

void FalloffPlot::show(const DeformationConstants& constants, const DentForm& form, Unit unit) {
    nameUnit(unit);
    m_constants = constants;
    m_form = form;
    if (form.presses()) {
        m_form = plain(form);
    }
    const QString what = tr("Displacement of a vertex against its distance from the hit point");
    setToolTip(isEditable() ? what + u'\n' +
                                  tr("Drag the points, or choose one with Left and Right and move it with Up "
                                     "and Down.")
                            : what);
    setFocusPolicy(isEditable() ? Qt::StrongFocus : Qt::NoFocus);
    if (m_form.hasPaperFunction()) {
        drawPaper();
    } else {
        drawForm();
    }
    drawPoints();
    m_plot->graph(Beyond)->setData({rim(), rim() * kBeyondRim}, {0.0, 0.0}, true);
    m_plot->xAxis->setRange(0.0, rim() * kBeyondRim);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void FalloffPlot::drawPaper() {
    const double cap = m_constants.maxMagnitude;
    const double corner = cap > 0.0 ? m_constants.power / cap : 0.0;
    QVector<double> distances;
    QVector<double> magnitudes;
    for (int i = 0; i <= kSamples; ++i) {
        const double r = rim() * i / kSamples;
        if (corner > 0.0 && corner < r && corner > rim() * (i - 1) / kSamples) {
            distances.append(corner);
            magnitudes.append(cap);
        }
        distances.append(r);
        magnitudes.append(magnitude(m_constants, r));
    }
    const double highest = magnitudes.front();
    m_plot->graph(Curve)->setData(distances, magnitudes, true);
    placeCorner(std::min(corner, rim()), highest);
    placeStep(rim(), magnitudes.back(), std::min(magnitude(m_constants, 0.6 * rim()), 0.75 * highest));
    for (QCPLayerable* item : {static_cast<QCPLayerable*>(m_step), static_cast<QCPLayerable*>(m_stepText)}) {
        item->setVisible(true);
    }
    m_cornerText->setVisible(corner < rim() && highest > 0.0);
    m_plot->graph(Corner)->setVisible(corner < rim() && highest > 0.0);
    setRange(0.0, highest);
}

void FalloffPlot::drawForm() {
    QVector<double> distances;
    QVector<double> magnitudes;
    for (int i = 0; i <= kSamples; ++i) {
        const double r = rim() * i / kSamples;
        distances.append(r);
        magnitudes.append(static_cast<double>(magnitudeOnPlane(m_form, m_constants, static_cast<float>(r))));
    }
    m_plot->graph(Curve)->setData(distances, magnitudes, true);
    m_cornerText->setVisible(false);
    m_plot->graph(Corner)->setVisible(false);
    // A curve may end above or below the surface.
    const auto step = static_cast<double>(m_form.curve.back() * m_constants.maxMagnitude);
    const bool hasStep = isEditable() && step != 0.0;
    m_step->setVisible(hasStep);
    m_stepText->setVisible(hasStep);
    const auto [lowest, highest] = std::minmax_element(magnitudes.begin(), magnitudes.end());
    placeStep(rim(), step, 0.5 * *highest);
    if (!m_isDragging) {
        const double cap = static_cast<double>(m_constants.maxMagnitude);
        const double room = isEditable() ? kEditRoom * cap : 0.0;
        setRange(std::min(*lowest, 0.0) - room, isEditable() ? cap : *highest);
    }
}

void FalloffPlot::drawPoints() {
    QVector<double> distances;
    QVector<double> magnitudes;
    for (std::size_t i = 0; isEditable() && i < kCurvePoints; ++i) {
        distances.append(rim() * static_cast<double>(i) / (kCurvePoints - 1));
        magnitudes.append(static_cast<double>(m_form.curve[i] * m_constants.maxMagnitude));
    }
    m_plot->graph(Points)->setData(distances, magnitudes, true);
    if (isEditable() && (hasFocus() || m_isDragging)) {
        m_plot->graph(Chosen)->setData({distances[m_point]}, {magnitudes[m_point]}, true);
    } else {
        m_plot->graph(Chosen)->setData(QVector<double>(), QVector<double>());
    }
}

void FalloffPlot::setRange(double lowest, double highest) {
    m_plot->yAxis->setRange(lowest < 0.0 ? lowest * kHeadroom : 0.0,
                            highest > 0.0 ? highest * kHeadroom : 1.0);
}

// The points of a curve

void FalloffPlot::takeMouse() {
    connect(m_plot, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
        if (event->button() == Qt::LeftButton && isEditable()) {
            press(event->position());
        }
    });
    connect(m_plot, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
        if (m_isDragging) {
            dragTo(event->position());
        }
    });
    connect(m_plot, &QCustomPlot::mouseRelease, this, [this] {
        if (std::exchange(m_isDragging, false)) {
            Q_EMIT curveFinished();
            show(m_constants, m_form, m_unitShown);
        }
    });
}

/// The nearest point is taken, from anywhere near its distance.
void FalloffPlot::press(const QPointF& at) {
    setFocus(Qt::MouseFocusReason);
    m_before = m_form.curve;
    const double share = m_plot->xAxis->pixelToCoord(at.x()) / rim();
    m_point = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * (kCurvePoints - 1)));
    m_isDragging = true;
    dragTo(at);
}

void FalloffPlot::dragTo(const QPointF& at) {
    const double cap = static_cast<double>(m_constants.maxMagnitude);
    if (cap > 0.0) {
        setOrdinate(m_plot->yAxis->pixelToCoord(at.y()) / cap);
    }
}

void FalloffPlot::setOrdinate(double ordinate) {
    CurveOrdinates curve = m_form.curve;
    const double rounded = std::round(std::clamp(ordinate, -1.0, 1.0) * kOrdinateSteps) / kOrdinateSteps;
    curve[static_cast<std::size_t>(m_point)] = static_cast<float>(rounded);
    setCurve(curve);
}

void FalloffPlot::setCurve(const CurveOrdinates& curve) {
    if (curve != m_form.curve) {
        m_form.curve = curve;
        show(m_constants, m_form, m_unitShown);
        Q_EMIT curveEdited(curve);
    }
}

void FalloffPlot::keyPressEvent(QKeyEvent* event) {
    const int last = static_cast<int>(kCurvePoints) - 1;
    const double step = (event->modifiers() & Qt::ShiftModifier) != 0 ? kFineStep : kStep;
    const double now = static_cast<double>(m_form.curve[static_cast<std::size_t>(m_point)]);
    switch (isEditable() ? event->key() : Qt::Key_unknown) {
        case Qt::Key_Escape:
            if (!std::exchange(m_isDragging, false)) {
                QWidget::keyPressEvent(event);
                return;
            }
            setCurve(m_before);
            Q_EMIT curveFinished();
            break;
        case Qt::Key_Left:
            m_point = std::max(m_point - 1, 0);
            break;
        case Qt::Key_Right:
            m_point = std::min(m_point + 1, last);
            break;
        case Qt::Key_Up:
            setOrdinate(now + step);
            Q_EMIT curveFinished();
            return;
        case Qt::Key_Down:
            setOrdinate(now - step);
            Q_EMIT curveFinished();
            return;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    drawPoints();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void FalloffPlot::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    drawPoints();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void FalloffPlot::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    drawPoints();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace hitscope
