// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/histogram/histogram_plot.h"

#include <QEvent>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/plot/custom_plot.h"
#include "panels/plot/plot_theme.h"

namespace hitscope {

namespace {

constexpr double kSideMargin = 0.03;  // of the span, to either side, so that handles at the ends can be held
constexpr double kLeastWidth = 1e-3;  // of the span: handles do not meet
constexpr int kColourStops = 16;

}  // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    m_plot->setMinimumSize(120, 90);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_plot->setMouseTracking(true);
    m_plot->installEventFilter(this);
    m_plot->setBufferDevicePixelRatio(devicePixelRatioF());
    m_bars = new QCPBars(m_plot->xAxis, m_plot->yAxis);
    m_bars->setWidthType(QCPBars::wtPlotCoords);
    m_bars->setAntialiased(false);
    const auto counts = QSharedPointer<QCPAxisTickerFixed>::create();
    counts->setTickStep(1.0);
    counts->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    counts->setTickCount(3);
    m_plot->yAxis->setTicker(counts);
    m_plot->xAxis->ticker()->setTickCount(4);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setLabelPadding(1);
        axis->setNumberFormat(QStringLiteral("gb"));
        axis->setNumberPrecision(4);
    }
    m_plot->axisRect()->setMinimumMargins(QMargins(4, 6, 8, 0));
    for (QCPItemStraightLine*& handle : m_handles) {
        handle = new QCPItemStraightLine(m_plot);
        handle->setVisible(false);
    }
    m_note = new QCPItemText(m_plot);
    m_note->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_note->position->setCoords(0.5, 0.5);
    applyPalette();
    setHistogram({});
}

HistogramPlot::~HistogramPlot() = default;

void HistogramPlot::setHistogram(const Histogram& histogram) {
    m_histogram = histogram;
    QVector<double> centres;
    QVector<double> counts;
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
        centres.append(histogram.low + (static_cast<double>(bin) + 0.5) * histogram.binWidth());
        counts.append(static_cast<double>(histogram.counts[bin]));
    }
    m_bars->setWidth(histogram.binWidth());
    m_bars->setData(centres, counts, true);
    m_note->setVisible(histogram.counts.empty());
    m_plot->yAxis->setTickLabels(!histogram.counts.empty());
    if (m_held == Handle::None) {
        fitAxes();
    }
    replot();
}

void HistogramPlot::setEmptyText(const QString& text) {
    m_emptyText = text;
    m_note->setText(text);
    replot();
}

void HistogramPlot::setLabels(const QString& quantity, const QString& count) {
    m_plot->xAxis->setLabel(quantity);
    m_plot->yAxis->setLabel(count);
    replot();
}

/// Bars and handles are all in sight.
void HistogramPlot::fitAxes() {
    double low = m_histogram.low;
    double high = m_histogram.high;
    if (m_histogram.counts.empty()) {
        low = m_range ? m_range->low : 0.0;
        high = m_range ? m_range->high : 1.0;
    } else if (m_range) {
        low = std::min(low, m_range->low);
        high = std::max(high, m_range->high);
    }
    const double margin = std::max((high - low) * kSideMargin, 1e-12);
    m_plot->xAxis->setRange(low - margin, high + margin);
    const auto most = std::max_element(m_histogram.counts.begin(), m_histogram.counts.end());
    m_plot->yAxis->setRange(0.0, most == m_histogram.counts.end() || *most == 0 ? 1.0 : *most * 1.08);
}

void HistogramPlot::setRange(const std::optional<Range>& range) {
    if (range == m_range || m_held != Handle::None) {
        return;
    }
    m_range = range;
    fitAxes();
    replot();
}

void HistogramPlot::setColours(std::function<QColor(double)> colourAt) {
    m_colourAt = std::move(colourAt);
    replot();
}

double HistogramPlot::pixelOf(double value) const {
    return m_plot->xAxis->coordToPixel(value) + m_plot->x();
}

void HistogramPlot::placeHandles() {
    for (int i = 0; i < 2; ++i) {
        m_handles[i]->setVisible(m_range.has_value());
        if (m_range) {
            const double at = i == 0 ? m_range->low : m_range->high;
            m_handles[i]->point1->setCoords(at, 0.0);
            m_handles[i]->point2->setCoords(at, 1.0);
        }
    }
}

void HistogramPlot::colourBars() {
    if (!m_colourAt || !m_range) {
        QColor plain = palette().color(QPalette::Highlight);
        plain.setAlphaF(0.8f);
        m_bars->setBrush(plain);
        return;
    }
    // The brush is in the plot's own pixels, so that each bar has the colour of its place in the range.
    QLinearGradient gradient(m_plot->xAxis->coordToPixel(m_range->low), 0.0,
                             m_plot->xAxis->coordToPixel(m_range->high), 0.0);
    for (int stop = 0; stop <= kColourStops; ++stop) {
        const double at = static_cast<double>(stop) / kColourStops;
        gradient.setColorAt(at, m_colourAt(at));
    }
    m_bars->setBrush(gradient);
}

void HistogramPlot::replot() {
    placeHandles();
    // The gradient needs the axes' place, which the layout decides.
    m_plot->plotLayout()->update(QCPLayoutElement::upLayout);
    colourBars();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void HistogramPlot::applyPalette() {
    applyPlotTheme(*m_plot, *this);
    const QColor ink = palette().color(QPalette::WindowText);
    m_plot->xAxis->grid()->setVisible(false);
    QColor outline = ink;  // the darkest colours of a map would vanish in a dark panel
    outline.setAlphaF(0.35f);
    m_bars->setPen(QPen(outline, 0));
    for (QCPItemStraightLine* handle : m_handles) {
        handle->setPen(QPen(ink, 2));
    }
    m_note->setColor(m_plot->xAxis->labelColor());
    m_note->setFont(font());
    replot();
}

void HistogramPlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        applyPalette();
    }
}

HistogramPlot::Handle HistogramPlot::handleAt(double pixel) const {
    if (!m_range) {
        return Handle::None;
    }
    const double toLow = std::abs(pixel - m_plot->xAxis->coordToPixel(m_range->low));
    const double toHigh = std::abs(pixel - m_plot->xAxis->coordToPixel(m_range->high));
    if (std::min(toLow, toHigh) > kGrip) {
        return Handle::None;
    }
    return toLow < toHigh ? Handle::Low : Handle::High;
}

void HistogramPlot::dragTo(double pixel) {
    const QCPRange axis = m_plot->xAxis->range();
    const double value = std::clamp(m_plot->xAxis->pixelToCoord(pixel), axis.lower, axis.upper);
    const double least = axis.size() * kLeastWidth;
    if (m_held == Handle::Low) {
        m_range->low = std::min(value, m_range->high - least);
    } else {
        m_range->high = std::max(value, m_range->low + least);
    }
    replot();
    Q_EMIT rangeDragged(m_range->low, m_range->high);
}

bool HistogramPlot::press(double pixel) {
    m_held = handleAt(pixel);
    return m_held != Handle::None;
}

bool HistogramPlot::release() {
    if (std::exchange(m_held, Handle::None) == Handle::None) {
        return false;
    }
    fitAxes();
    replot();
    Q_EMIT rangeChosen(m_range->low, m_range->high);
    return true;
}

bool HistogramPlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_plot) {
        switch (event->type()) {
            case QEvent::MouseButtonPress: {
                const auto* mouse = static_cast<QMouseEvent*>(event);
                return mouse->button() == Qt::LeftButton && press(mouse->position().x());
            }
            case QEvent::MouseMove: {
                const double pixel = static_cast<QMouseEvent*>(event)->position().x();
                if (m_held != Handle::None) {
                    dragTo(pixel);
                    return true;
                }
                m_plot->setCursor(handleAt(pixel) == Handle::None ? Qt::ArrowCursor : Qt::SplitHCursor);
                break;
            }
            case QEvent::MouseButtonRelease:
                return static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton && release();
            case QEvent::Resize:
                // Handled by the plot first, then the gradient follows.
                QMetaObject::invokeMethod(this, &HistogramPlot::replot, Qt::QueuedConnection);
                break;
            default:
                break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace hitscope
