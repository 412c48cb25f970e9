// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/fields/drag_out.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDrag>
#include <QMimeData>
#include <QMouseEvent>
#include <utility>

namespace hitscope {

DragOut::DragOut(QAbstractButton& button, std::function<QMimeData*()> make)
    : QObject(&button), m_button(button), m_make(std::move(make)) {
    button.installEventFilter(this);
}

bool DragOut::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease) {
        const auto& mouse = static_cast<const QMouseEvent&>(*event);
        const bool isPress = event->type() == QEvent::MouseButtonPress && mouse.button() == Qt::LeftButton;
        m_pressedAt =
            isPress && m_button.isEnabled() ? std::optional(mouse.position().toPoint()) : std::nullopt;
    } else if (event->type() == QEvent::MouseMove && m_pressedAt) {
        const QPoint way = static_cast<const QMouseEvent&>(*event).position().toPoint() - *m_pressedAt;
        if (way.manhattanLength() >= QApplication::startDragDistance()) {
            m_pressedAt.reset();
            m_button.setDown(false);  // the button does not see the mouse let go
            drag();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

void DragOut::drag() {
    if (QMimeData* data = make()) {
        auto* drag = new QDrag(&m_button);  // Qt deletes it
        drag->setMimeData(data);
        drag->setPixmap(m_button.icon().pixmap(m_button.iconSize()));
        drag->exec(Qt::CopyAction);
    }
}

}  // namespace hitscope
