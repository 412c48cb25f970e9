// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/capacity_meter.h"

#include <QEvent>
#include <QGuiApplication>
#include <algorithm>

#include "models/quantity_text.h"

namespace hitscope {

namespace {

constexpr QRgb kFullOnLight = 0xffc0503f;
constexpr QRgb kFullOnDark = 0xffa8483b;
constexpr int kPadding = 24;  // pixels beside the text

/// "Uniform array" in the middle of a sentence.
QString nameInside(PipelineKind kind) {
    const std::string_view name = pipelineTraits(kind).name;
    QString text = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    text[0] = text[0].toLower();
    return text;
}

}  // namespace

CapacityMeter::CapacityMeter(QWidget* parent) : QProgressBar(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    hide();
}

void CapacityMeter::follow(const Session& session) {
    const auto update = [this, &session] { read(session); };
    connect(&session, &Session::capacityChanged, this, update);
    connect(&session, &Session::pipelineChanged, this, update);
    update();
}

void CapacityMeter::read(const Session& session) {
    const CapacityReport& report = session.capacity();
    setVisible(report.capacity.has_value());
    if (!report.capacity) {
        return;
    }
    const QString used = countText(report.used);
    const QString capacity = countText(*report.capacity);
    const QString pipeline = nameInside(session.pipeline());
    setRange(0, std::max(1, static_cast<int>(*report.capacity)));
    setValue(std::min(maximum(), static_cast<int>(report.used)));
    setFormat(report.perTarget ? tr("%1 of %2 hits on the fullest target").arg(used, capacity)
                               : tr("%1 of %2 hits in the %3").arg(used, capacity, pipeline));
    QString tip = report.perTarget
                      ? tr("The %1 keeps the last %2 hits on each target; older ones are dropped.")
                      : tr("The %1 keeps the last %2 hits of the scene; older ones are dropped.");
    tip = tip.arg(pipeline, capacity);
    if (!report.dropped.empty()) {
        tip += u'\n' + tr("Dropped so far: %1. They are grey in the table and count again in a pipeline "
                          "without a limit.")
                           .arg(countText(report.dropped.size()));
    }
    setToolTip(tip);
    updateGeometry();
    colour();
}

void CapacityMeter::colour() {
    QPalette palette = QGuiApplication::palette();
    if (maximum() > 0 && value() == maximum()) {
        const bool dark =
            palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
        palette.setColor(QPalette::Highlight, QColor(dark ? kFullOnDark : kFullOnLight));
    }
    if (palette != this->palette()) {
        setPalette(palette);
    }
}

void CapacityMeter::changeEvent(QEvent* event) {
    QProgressBar::changeEvent(event);
    if (event->type() == QEvent::ApplicationPaletteChange) {
        colour();
    }
}

QSize CapacityMeter::sizeHint() const {
    return {fontMetrics().horizontalAdvance(text()) + kPadding, fontMetrics().height() + 2};
}

QSize CapacityMeter::minimumSizeHint() const {
    return {kPadding, sizeHint().height()};
}

}  // namespace hitscope
