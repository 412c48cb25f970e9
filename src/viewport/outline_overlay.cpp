// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/outline_overlay.h"

#include <QPainter>

namespace hitscope {

OutlineOverlay::OutlineOverlay(QWidget* over) : QWidget(over) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void OutlineOverlay::show(const QPolygonF& outline) {
    m_outline = outline;
    if (outline.isEmpty()) {
        hide();
        return;
    }
    setGeometry(parentWidget()->rect());
    QWidget::show();
    raise();
    update();
}

void OutlineOverlay::paintEvent(QPaintEvent*) {
    constexpr int kFill = 40;  // of 255
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor line = palette().color(QPalette::Highlight);
    QColor fill = line;
    fill.setAlpha(kFill);
    painter.setPen(QPen(line, 1.5));
    painter.setBrush(fill);
    painter.drawPolygon(m_outline, Qt::OddEvenFill);
}

}  // namespace hitscope
