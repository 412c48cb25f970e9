// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/change_overlay.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/change_values.h"
#include "analysis/comparison.h"
#include "analysis/comparison_text.h"
#include "scene/bar_labels.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr double kEdge = 12.0;    // logical pixels from the picture's edges
constexpr double kPadding = 8.0;  // within a plate
constexpr double kBarWidth = 14.0;
constexpr double kMostBarHeight = 190.0;
constexpr double kLeastBarHeight = 48.0;  // a picture that has no room for it goes without
constexpr double kTick = 4.0;

QString words(const char* text) {
    return QCoreApplication::translate("hitscope::ChangeOverlay", text);
}

struct Ink {
    QColor text;
    QColor plate;
};

Ink inkOf(Theme theme) {
    return theme == Theme::Dark ? Ink{{235, 238, 244}, {24, 26, 30, 185}}
                                : Ink{{24, 28, 36}, {250, 251, 253, 205}};
}

void paintPlate(QPainter& painter, const QRectF& rect, const Ink& ink) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink.plate);
    painter.drawRoundedRect(rect, 5, 5);
}

/// A line of text on a plate, its middle at `centre` across and its top at `top`.
void paintNote(QPainter& painter, const QString& note, double centre, double top, const Ink& ink) {
    const QFontMetricsF metrics(painter.font());
    const QRectF rect(centre - metrics.horizontalAdvance(note) / 2 - kPadding, top,
                      metrics.horizontalAdvance(note) + 2 * kPadding, metrics.height() + kPadding);
    paintPlate(painter, rect, ink);
    painter.setPen(ink.text);
    painter.drawText(rect, Qt::AlignCenter, note);
}

/// What a plate with the bar is higher than the bar, in lines of text that high.
double aroundBar(double textHeight) {
    return 2.2 * textHeight + 2 * kPadding;
}

/// What is written below, between two pictures.
double notesBelow(double textHeight) {
    return 2.0 * (textHeight + kPadding) + kPadding;
}

QString titleOf(const ShownChange& change) {
    const ChangeTraits& traits = changeTraits(change.quantity);
    const QString name = QString::fromUtf8(traits.name);
    const QString unit = QString::fromUtf8(traits.unit);
    return unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit);
}

QString unchangedText() {
    return words(QT_TRANSLATE_NOOP("hitscope::ChangeOverlay", "No change"));
}

/// By the values of all vertices; a range that somebody gave holds whether anything changed or not.
bool isUnchanged(const SceneGpu::View& view) {
    return view.options.change.style().automatic && view.changeValues != nullptr &&
           view.changeValues->isComplete() && view.changeValues->summary().count == 0;
}

void paintBar(QPainter& painter, const QRectF& bar, ColourMap map) {
    const ColourTable& table = colourTable(map);
    QImage colours(1, static_cast<int>(table.size()), QImage::Format_RGB32);
    for (std::size_t i = 0; i < table.size(); ++i) {
        colours.setPixelColor(0, static_cast<int>(table.size() - 1 - i),
                              QColor(table[i][0], table[i][1], table[i][2]));
    }
    painter.drawImage(bar, colours);
}

}  // namespace

bool ChangeOverlay::Legend::operator==(const Legend& other) const {
    return title == other.title && change.range == other.change.range && change.map == other.change.map &&
           change.quantity == other.change.quantity && change.isolineStep == other.change.isolineStep &&
           theme == other.theme && pixelRatio == other.pixelRatio && barHeight == other.barHeight &&
           unchanged == other.unchanged;
}

void ChangeOverlay::paintLegend(QPainter& painter, const QSizeF& size, const Legend& legend) {
    if (m_bar.isNull() || !(legend == m_drawn)) {
        m_drawn = legend;
        const Ink ink = inkOf(legend.theme);
        const QFontMetricsF metrics(painter.font());
        const double high = metrics.height();
        const std::vector<BarLabel> labels = legend.unchanged
                                                 ? std::vector{BarLabel{0.0, unchangedText()}}
                                                 : barLabels(legend.change, 1.15 * high / legend.barHeight);
        double widest = 0.0;
        for (const BarLabel& label : labels) {
            widest = std::max(widest, metrics.horizontalAdvance(label.text));
        }
        const double width =
            std::max(metrics.horizontalAdvance(legend.title), kBarWidth + 2 * kTick + widest + kTick) +
            2 * kPadding;
        const QSizeF plate(std::ceil(width), std::ceil(legend.barHeight + aroundBar(high)));
        const double ratio = static_cast<double>(legend.pixelRatio);
        m_bar = QImage((plate * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
        m_bar.setDevicePixelRatio(ratio);
        m_bar.fill(Qt::transparent);
        QPainter drawing(&m_bar);
        drawing.setRenderHint(QPainter::Antialiasing);
        drawing.setFont(painter.font());
        paintPlate(drawing, QRectF({}, plate), ink);
        drawing.setPen(ink.text);
        drawing.drawText(QRectF(kPadding, kPadding, width, high), Qt::AlignLeft | Qt::AlignVCenter,
                         legend.title);
        const QRectF bar(kPadding, kPadding + 1.7 * high, kBarWidth, legend.barHeight);
        paintBar(drawing, bar, legend.change.map);
        const double low = static_cast<double>(legend.change.range.low);
        const double span = static_cast<double>(legend.change.range.high) - low;
        drawing.setPen(QPen(ink.text, 1));
        for (const BarLabel& label : labels) {
            const double y = bar.bottom() - (label.value - low) / span * bar.height();
            drawing.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + kTick, y));
            drawing.drawText(QRectF(bar.right() + 2 * kTick, y - high / 2, widest + kTick, high),
                             Qt::AlignLeft | Qt::AlignVCenter, label.text);
        }
    }
    const QSizeF plate = m_bar.deviceIndependentSize();
    if (plate.width() > size.width() / 2) {
        return;  // it would hide what it explains
    }
    // Beside the picture's side; of two pictures, between them, so that it covers as little of one as of the
    // other.
    const double left = legend.between ? size.width() / 2 - plate.width() / 2 : kEdge;
    const bool isOverNotes =
        legend.between || left + plate.width() + kPadding > size.width() / 2 - legend.notes / 2;
    const double below =
        isOverNotes && legend.notes > 0.0 ? notesBelow(QFontMetricsF(painter.font()).height()) : 0.0;
    const QPointF at(left, size.height() - plate.height() - kEdge - below);
    painter.drawImage(QPointF(std::round(at.x()), std::round(at.y())), m_bar);
}

namespace {

bool isComparing(const SceneGpu::View& view) {
    return view.comparison != nullptr && view.comparison->other().has_value();
}

QString nameOf(char letter, PipelineKind kind) {
    const std::string_view name = pipelineTraits(kind).name;
    return QStringLiteral("%1: %2").arg(QLatin1Char(letter)).arg(QString::fromUtf8(name));
}

void paintComparison(QPainter& painter, const SceneGpu::View& view, const QSizeF& size, const Ink& ink) {
    const Comparison& comparison = *view.comparison;
    const double high = QFontMetricsF(painter.font()).height() + kPadding;
    const BeforeAfterOptions& beforeAfter = view.options.beforeAfter;
    const QString a = nameOf('A', comparison.first());
    const QString b = nameOf('B', *comparison.other());
    const double top = kEdge + (beforeAfter.wipe ? high + kPadding / 2 : 0.0);
    if (view.options.sideBySide) {
        const double middle = std::floor(size.width() / 2);
        painter.setPen(QPen(ink.text, 1));
        painter.drawLine(QPointF(middle, 0), QPointF(middle, size.height()));
        paintNote(painter, a, middle / 2, top, ink);
        paintNote(painter, b, middle + middle / 2, top, ink);
    } else {
        paintNote(painter, a + QStringLiteral("   ") + b, size.width() / 2, top, ink);
    }
    const double above = beforeAfter.exaggeration != 1.0f ? high + kPadding / 2 : 0.0;
    paintNote(painter, comparisonText(comparison), size.width() / 2, size.height() - kEdge - high - above,
              ink);
}

QString exaggerationNote(float factor) {
    return words(QT_TRANSLATE_NOOP("hitscope::ChangeOverlay", "Displacement drawn %1×"))
        .arg(shownNumber(static_cast<double>(factor), 'g', 3));
}

/// Of what is written below in the middle.
double notesWidth(const QFontMetricsF& metrics, const SceneGpu::View& view) {
    double widest = 0.0;
    if (isComparing(view)) {
        widest = metrics.horizontalAdvance(comparisonText(*view.comparison));
    }
    if (const float factor = view.options.beforeAfter.exaggeration; factor != 1.0f) {
        widest = std::max(widest, metrics.horizontalAdvance(exaggerationNote(factor)));
    }
    return widest > 0.0 ? widest + 2 * kPadding : 0.0;
}

struct Columns {
    double from;
    double to;
};

/// The line within one picture, and what is on its sides.
void paintWipe(QPainter& painter, const BeforeAfterOptions& options, const Columns& picture, double height,
               const Ink& ink) {
    const double line =
        std::round(picture.from + static_cast<double>(options.wipeAt) * (picture.to - picture.from));
    painter.setPen(QPen(ink.plate, 3));
    painter.drawLine(QPointF(line, 0), QPointF(line, height));
    painter.setPen(QPen(ink.text, 1));
    painter.drawLine(QPointF(line, 0), QPointF(line, height));
    const QFontMetricsF metrics(painter.font());
    const QString before = words(QT_TRANSLATE_NOOP("hitscope::ChangeOverlay", "Original"));
    const QString after = words(QT_TRANSLATE_NOOP("hitscope::ChangeOverlay", "Deformed"));
    paintNote(painter, before, line - kEdge - kPadding - metrics.horizontalAdvance(before) / 2, kEdge, ink);
    paintNote(painter, after, line + kEdge + kPadding + metrics.horizontalAdvance(after) / 2, kEdge, ink);
}

}  // namespace

bool ChangeOverlay::isNeeded(const SceneGpu::View& view) {
    return isComparing(view) || view.options.change.on || view.options.beforeAfter.wipe ||
           view.options.beforeAfter.exaggeration != 1.0f;
}

void ChangeOverlay::paint(QPainter& painter, const SceneGpu::View& view) {
    const QSizeF size = QSizeF(view.width, view.height) / static_cast<double>(view.pixelRatio);
    const Ink ink = inkOf(view.options.theme);
    const BeforeAfterOptions& beforeAfter = view.options.beforeAfter;
    painter.setRenderHint(QPainter::Antialiasing);
    if (isComparing(view)) {
        paintComparison(painter, view, size, ink);  // its line, which the colour bar stands on
    }
    if (view.options.change.on) {
        const ShownChange change =
            shownChange(view.options.change, view.changeValues ? view.changeValues->summary() : Summary());
        const bool between = isComparing(view) && view.options.sideBySide;
        const QFontMetricsF metrics(painter.font());
        const double high = metrics.height();
        const double notes = notesWidth(metrics, view);
        const double room =
            size.height() - 2 * kEdge - aroundBar(high) - (notes > 0.0 ? notesBelow(high) : 0.0);
        if (room >= kLeastBarHeight) {
            paintLegend(painter, size,
                        {titleOf(change), change, view.options.theme, view.pixelRatio, between,
                         isUnchanged(view), std::min(room, kMostBarHeight), notes});
        }
    }
    if (beforeAfter.wipe) {
        const bool two = isComparing(view) && view.options.sideBySide;
        const double width = two ? std::floor(size.width() / 2) : size.width();
        paintWipe(painter, beforeAfter, {0.0, width}, size.height(), ink);
        if (two) {
            paintWipe(painter, beforeAfter, {width, size.width()}, size.height(), ink);
        }
    }
    if (beforeAfter.exaggeration != 1.0f) {
        const QString note = exaggerationNote(beforeAfter.exaggeration);
        const QFontMetricsF metrics(painter.font());
        paintNote(painter, note, size.width() / 2, size.height() - kEdge - metrics.height() - kPadding, ink);
    }
}

}  // namespace hitscope
