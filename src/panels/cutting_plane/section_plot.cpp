// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/cutting_plane/section_plot.h"

#include <QEvent>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "models/quantity_text.h"
#include "panels/plot/custom_plot.h"
#include "panels/plot/plot_theme.h"
#include "view/theme.h"

namespace hitscope {

namespace {

constexpr double kReach = 28.0;   // pixels from the cursor to a line that it still points at
constexpr double kMargin = 1.12;  // of the room
constexpr double kLeast = 1.0;    // metres, around what is a single point
constexpr double kDot = 7.0;      // pixels

QString axisLabel(const SectionView::Axis& axis, const QString& word) {
    return axis.name != 0 ? QStringLiteral("%1 (m)").arg(QLatin1Char(axis.name)) : word;
}

void fillCurve(QCPCurve& plotted, const SceneSection& section, const SectionScope& scope,
               const SectionView& view, std::vector<SectionCurve> TargetSection::*which) {
    QVector<QCPCurveData> data;
    double t = 0.0;
    const auto add = [&data, &t](const glm::dvec2& at) { data.append({t++, at.x, at.y}); };
    const auto gap = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    for (const TargetSection& target : section.targets) {
        if (!scope.holds(target)) {
            continue;
        }
        for (const SectionCurve& curve : target.*which) {
            for (const glm::vec3& point : curve.points) {
                add(view(point));
            }
            if (curve.closed && !curve.points.empty()) {
                add(view(curve.points.front()));
            }
            add(gap);
        }
    }
    plotted.data()->set(data, true);
}

}  // namespace

SectionPlot::SectionPlot(QWidget* parent)
    : QWidget(parent),
      m_plot(new QCustomPlot(this)),
      m_original(new QCPCurve(m_plot->xAxis, m_plot->yAxis)),
      m_deformed(new QCPCurve(m_plot->xAxis, m_plot->yAxis)),
      m_deepest(new QCPItemLine(m_plot)),
      m_deepestText(new QCPItemText(m_plot)),
      m_pointed(new QCPItemLine(m_plot)),
      m_cursor(new QCPItemTracer(m_plot)),
      m_note(new QCPItemText(m_plot)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_plot);
    m_plot->setBufferDevicePixelRatio(devicePixelRatioF());
    m_plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    m_plot->setMouseTracking(true);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setLabelPadding(1);
        axis->ticker()->setTickCount(4);
    }
    m_deepestText->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
    m_deepestText->setPadding({5, 2, 5, 2});
    m_cursor->setStyle(QCPItemTracer::tsCircle);
    m_cursor->setSize(kDot);
    m_note->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_note->position->setCoords(0.5, 0.5);
    m_note->setText(tr("The plane cuts nothing"));
    connect(m_plot, &QCustomPlot::mouseMove, this,
            [this](QMouseEvent* event) { followCursor(event->position()); });
    connect(m_plot, &QCustomPlot::mouseDoubleClick, this, &SectionPlot::showAll);
    const auto moved = [this](QMouseEvent* event) {
        m_isMoved = m_isMoved || event->buttons() != Qt::NoButton;
    };
    connect(m_plot, &QCustomPlot::mouseMove, this, moved);
    connect(m_plot, &QCustomPlot::mouseWheel, this, [this] { m_isMoved = true; });
    applyPalette();
    setSection(nullptr, {}, {});
}

void SectionPlot::setSection(std::shared_ptr<const SceneSection> section, const SectionScope& scope,
                             const QRectF& room) {
    m_section = std::move(section);
    m_scope = scope;
    if (m_section) {
        m_view = sectionView(m_section->cut.openSide());
    }
    m_plot->xAxis->setLabel(axisLabel(m_view.right, tr("across (m)")));
    m_plot->yAxis->setLabel(axisLabel(m_view.up, tr("up (m)")));
    m_plot->xAxis->setRangeReversed(m_view.right.mirrored);
    m_plot->yAxis->setRangeReversed(m_view.up.mirrored);
    if (room != m_room) {
        m_room = room;
        m_isMoved = false;
    }
    m_pointed->setVisible(false);
    m_cursor->setVisible(false);
    drawCurves();
    markDeepest();
    if (!m_isMoved) {
        fit();
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void SectionPlot::setShown(bool original, bool deformed) {
    m_original->setVisible(original);
    m_deformed->setVisible(deformed);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void SectionPlot::drawCurves() {
    const bool isAny = m_section && !m_section->targets.empty();
    m_note->setVisible(m_section && !isAny);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setTickLabels(isAny);
    }
    if (!isAny) {
        m_original->data()->clear();
        m_deformed->data()->clear();
        return;
    }
    fillCurve(*m_original, *m_section, m_scope, m_view, &TargetSection::original);
    fillCurve(*m_deformed, *m_section, m_scope, m_view, &TargetSection::deformed);
}

void SectionPlot::markDeepest() {
    const auto deepest = m_section ? deepestOf(*m_section, m_scope) : std::nullopt;
    m_deepest->setVisible(deepest.has_value());
    m_deepestText->setVisible(deepest.has_value());
    if (!deepest) {
        return;
    }
    const glm::dvec2 place = m_view(deepest->place);
    const glm::dvec2 nearest = m_view(*deepest->nearest);
    m_deepest->start->setCoords(place.x, place.y);
    m_deepest->end->setCoords(nearest.x, nearest.y);
    // Beside the dent, towards the section's middle: there is room.
    const QPointF middle = m_room.center();
    const bool isLeft = (place.x < middle.x()) != m_view.right.mirrored;
    const bool isLow = (place.y < middle.y()) != m_view.up.mirrored;
    m_deepestText->setPositionAlignment((isLeft ? Qt::AlignLeft : Qt::AlignRight) |
                                        (isLow ? Qt::AlignBottom : Qt::AlignTop));
    m_deepestText->position->setCoords(place.x, place.y);
    m_deepestText->setText(tr("%1 m").arg(quantityText(*deepest->depth)));
}

void SectionPlot::fit() {
    if (!m_section || m_section->targets.empty()) {
        return;
    }
    // The section of a flat target may have no height, no width, or neither.
    const QPointF middle = m_room.center();
    const bool isPoint = !(m_room.width() > 0.0) && !(m_room.height() > 0.0);
    const double width = isPoint ? kLeast : kMargin * m_room.width();
    const double height = isPoint ? kLeast : kMargin * m_room.height();
    const QRect pixels = m_plot->axisRect()->rect();
    const double scale = std::max(width / std::max(1, pixels.width()), height / std::max(1, pixels.height()));
    m_plot->xAxis->setRange(middle.x(), scale * pixels.width(), Qt::AlignCenter);
    m_plot->yAxis->setRange(middle.y(), scale * pixels.height(), Qt::AlignCenter);
}

void SectionPlot::showAll() {
    m_isMoved = false;
    fit();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

QPointF SectionPlot::pixelOf(const glm::vec3& place) const {
    const glm::dvec2 at = m_view(place);
    return m_plot->mapToParent(
        QPointF(m_plot->xAxis->coordToPixel(at.x), m_plot->yAxis->coordToPixel(at.y)).toPoint());
}

std::optional<SectionReading> SectionPlot::readingAt(const QPointF& position) const {
    if (!m_section) {
        return std::nullopt;
    }
    const QPointF at = position - m_plot->pos();
    const glm::dvec2 flat(m_plot->xAxis->pixelToCoord(at.x()), m_plot->yAxis->pixelToCoord(at.y()));
    const auto reading = readSection(*m_section, m_scope, flat);
    if (!reading) {
        return std::nullopt;
    }
    const QPointF off = pixelOf(reading->place) - position;
    return std::hypot(off.x(), off.y()) <= kReach ? reading : std::nullopt;
}

QString SectionPlot::textOf(const SectionReading& reading) const {
    const QString place = placeText(m_view, reading.place);
    return reading.depth ? tr("%1\n%2 m deep").arg(place, quantityText(*reading.depth))
                         : tr("%1\nThe plane does not cut the original").arg(place);
}

void SectionPlot::followCursor(const QPointF& position) {
    const auto reading = readingAt(position + m_plot->pos());
    m_cursor->setVisible(reading.has_value());
    m_pointed->setVisible(reading && reading->nearest);
    if (reading) {
        const glm::dvec2 place = m_view(reading->place);
        const glm::dvec2 nearest = m_view(reading->nearest.value_or(reading->place));
        m_cursor->position->setCoords(place.x, place.y);
        m_pointed->start->setCoords(place.x, place.y);
        m_pointed->end->setCoords(nearest.x, nearest.y);
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
    QToolTip::showText(m_plot->mapToGlobal(position.toPoint()), reading ? textOf(*reading) : QString(),
                       m_plot);
}

void SectionPlot::applyPalette() {
    applyPlotTheme(*m_plot, *this);
    const QColor ink = palette().color(QPalette::WindowText);
    // The picture's own colour for it.
    const bool isDark = palette().color(QPalette::Base).lightness() < 128;
    const glm::vec3 line = themeColours(isDark ? Theme::Dark : Theme::Light).accent;
    const QColor accent = QColor::fromRgbF(line.r, line.g, line.b);
    QColor dim = ink;
    dim.setAlphaF(0.65f);
    QPen original(dim, 1.2);
    original.setDashPattern({4.0, 3.0});
    m_original->setPen(original);
    m_deformed->setPen(QPen(accent, 1.8));
    m_deepest->setPen(QPen(ink, 1.4));
    m_deepest->setTail(QCPLineEnding(QCPLineEnding::esDisc, 5, 5));
    m_deepestText->setColor(ink);
    m_deepestText->setFont(font());
    m_pointed->setPen(QPen(dim, 1));
    m_cursor->setPen(QPen(ink, 1.4));
    m_cursor->setBrush(palette().color(QPalette::Base));
    m_note->setColor(dim);
    m_note->setFont(font());
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void SectionPlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        applyPalette();
    }
}

void SectionPlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Once the plot has laid itself out.
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_plot->replot();
            if (!m_isMoved) {
                showAll();
            }
        },
        Qt::QueuedConnection);
}

}  // namespace hitscope
