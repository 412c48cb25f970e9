// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/lights/colour_button.h"

#include <QColorDialog>
#include <QEvent>
#include <QPainter>

namespace hitscope {

ColourButton::ColourButton(QWidget* parent) : QToolButton(parent) {
    setIconSize({28, 14});
    connect(this, &QToolButton::clicked, this, &ColourButton::choose);
    drawSwatch();
}

void ColourButton::setColour(const QColor& colour) {
    if (colour != m_colour) {
        m_colour = colour;
        drawSwatch();
    }
}

void ColourButton::changeEvent(QEvent* event) {
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::EnabledChange) {
        drawSwatch();
    }
}

void ColourButton::drawSwatch() {
    const qreal ratio = devicePixelRatioF();
    QPixmap swatch(iconSize() * ratio);
    swatch.setDevicePixelRatio(ratio);
    swatch.fill(Qt::transparent);
    QPainter painter(&swatch);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(m_colour);
    painter.drawRoundedRect(QRectF(QPointF(0.5, 0.5), QSizeF(iconSize()) - QSizeF(1.0, 1.0)), 3.0, 3.0);
    setIcon(swatch);
}

void ColourButton::choose() {
    auto* dialog = new QColorDialog(m_colour, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(m_dialogTitle);
    const QColor before = m_colour;
    connect(dialog, &QColorDialog::currentColorChanged, this, [this](const QColor& colour) {
        setColour(colour);
        Q_EMIT colourTried(colour);
    });
    connect(dialog, &QColorDialog::rejected, this, [this, before] {
        setColour(before);
        Q_EMIT cancelled();
    });
    connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& colour) {
        setColour(colour);
        Q_EMIT colourPicked(colour);
    });
    dialog->open();
}

}  // namespace hitscope
