// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/capacity_meter.h"

#include <QStyleOptionProgressBar>
#include <QStylePainter>
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
    QString text = QString::fromUtf8(name);
    text[0] = text[0].toLower();
    return text;
}

}  // namespace

CapacityMeter::CapacityMeter(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    hide();
}

void CapacityMeter::follow(const Session& session) {
    const auto update = [this, &session] { read(session); };
    connect(&session.readBack(), &ReadBack::capacityChanged, this, update);
    connect(&session.settings(), &SessionSettings::pipelineChanged, this, update);
    update();
}

void CapacityMeter::read(const Session& session) {
    const CapacityReport& report = session.readBack().capacity();
    setVisible(report.capacity.has_value());
    if (!report.capacity) {
        return;
    }
    const QString used = countText(report.used);
    const QString capacity = countText(*report.capacity);
    const QString pipeline = nameInside(session.settings().pipeline());
    m_capacity = std::max(1, static_cast<int>(*report.capacity));
    m_used = std::min(m_capacity, static_cast<int>(report.used));
    m_text = report.perTarget ? tr("%1 of %2 hits on the fullest target").arg(used, capacity)
                              : tr("%1 of %2 hits in the %3").arg(used, capacity, pipeline);
    QString tip = report.perTarget
                      ? tr("The %1 keeps the last %2 hits on each target; older ones are dropped.")
                      : tr("The %1 keeps the last %2 hits of the scene; older ones are dropped.");
    tip = tip.arg(pipeline, capacity);
    if (report.byDriver) {
        tip += u'\n' + tr("This graphics driver has room for no more.");
    }
    if (!report.dropped.empty()) {
        tip += u'\n' + tr("Dropped so far: %1. They are grey in the table and count again in a pipeline "
                          "without a limit.")
                           .arg(countText(report.dropped.size()));
    }
    setToolTip(tip);
    updateGeometry();
    update();
}

void CapacityMeter::paintEvent(QPaintEvent*) {
    QStyleOptionProgressBar option;
    option.initFrom(this);
    option.state |= QStyle::State_Horizontal;
    option.maximum = m_capacity;
    option.progress = m_used;
    option.text = fontMetrics().elidedText(m_text, Qt::ElideRight, width() - 4);
    option.textVisible = true;
    option.textAlignment = Qt::AlignCenter;
    if (isFull()) {
        const bool dark =
            palette().color(QPalette::WindowText).lightness() > palette().color(QPalette::Window).lightness();
        option.palette.setColor(QPalette::Highlight, QColor(dark ? kFullOnDark : kFullOnLight));
    }
    QStylePainter(this).drawControl(QStyle::CE_ProgressBar, option);
}

QSize CapacityMeter::sizeHint() const {
    return {fontMetrics().horizontalAdvance(m_text) + kPadding, fontMetrics().height() + 2};
}

QSize CapacityMeter::minimumSizeHint() const {
    return {kPadding, sizeHint().height()};
}

}  // namespace hitscope
