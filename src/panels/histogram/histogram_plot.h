// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>
#include <functional>
#include <optional>

#include "core/histogram.h"

class QCPBars;
class QCPItemStraightLine;
class QCPItemText;
class QCustomPlot;

namespace hitscope {

/// A histogram as a plot. It may have a range: two handles, upright lines that the mouse drags, between which
/// the bars are coloured as a colour map does. For any quantity; knows no session.
class HistogramPlot : public QWidget {
    Q_OBJECT
public:
    explicit HistogramPlot(QWidget* parent = nullptr);
    ~HistogramPlot() override;

    /// Bars over the histogram's span; without bins `emptyText` is shown instead.
    void setHistogram(const Histogram& histogram);
    [[nodiscard]] const Histogram& histogram() const { return m_histogram; }
    void setEmptyText(const QString& text);
    /// What the axes say: "displacement (m)", "vertices".
    void setLabels(const QString& quantity, const QString& count);

    struct Range {
        double low = 0.0;
        double high = 1.0;  ///< > low
        bool operator==(const Range&) const = default;
    };
    /// Nothing: no handles. Emits nothing.
    void setRange(const std::optional<Range>& range);
    [[nodiscard]] const std::optional<Range>& range() const { return m_range; }
    /// The colour at [0, 1] of the range; an empty function: all bars in the highlight's colour.
    void setColours(std::function<QColor(double)> colourAt);

    /// Where a value is across the widget, in logical pixels: for tests and tools that point.
    [[nodiscard]] double pixelOf(double value) const;

    static constexpr int kGrip = 6;  ///< logical pixels to either side of a handle that take hold of it

Q_SIGNALS:
    void rangeDragged(double low, double high);  ///< at every step of the mouse
    void rangeChosen(double low, double high);   ///< the mouse has let go

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    enum class Handle { None, Low, High };

    void applyPalette();
    void fitAxes();
    void colourBars();
    void placeHandles();
    void replot();
    [[nodiscard]] Handle handleAt(double pixel) const;
    void dragTo(double pixel);
    bool press(double pixel);
    bool release();

    Histogram m_histogram;
    std::optional<Range> m_range;
    std::function<QColor(double)> m_colourAt;
    QString m_emptyText;
    Handle m_held = Handle::None;
    QCustomPlot* m_plot = nullptr;
    QCPBars* m_bars = nullptr;
    QCPItemStraightLine* m_handles[2] = {};
    QCPItemText* m_note = nullptr;
};

}  // namespace hitscope
