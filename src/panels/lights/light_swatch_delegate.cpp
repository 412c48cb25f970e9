// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/lights/light_swatch_delegate.h"

#include <QPainter>
#include <QPixmap>

#include "models/lights_model.h"

namespace hitscope {

namespace {

constexpr int kSide = 14;  // logical pixels

QPixmap swatch(const QColor& colour, const QColor& frame, qreal ratio) {
    QPixmap pixmap(QSize(kSide, kSide) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(frame);
    painter.setBrush(colour);
    painter.drawEllipse(QRectF(1.0, 1.0, kSide - 2.0, kSide - 2.0));
    return pixmap;
}

}  // namespace

void LightSwatchDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    const bool on = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    QColor colour(index.data(LightsModel::ColourRole).toString());
    colour.setAlphaF(on ? 1.0f : 0.15f);
    const qreal ratio = option->widget != nullptr ? option->widget->devicePixelRatioF() : 1.0;
    option->features |= QStyleOptionViewItem::HasDecoration;
    option->decorationSize = QSize(kSide, kSide);
    option->icon = QIcon(swatch(colour, option->palette.color(QPalette::Mid), ratio));
    if (!on) {
        option->palette.setColor(QPalette::Text, option->palette.color(QPalette::Disabled, QPalette::Text));
    }
}

}  // namespace hitscope
