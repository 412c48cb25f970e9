// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handles/wipe_handle.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

WipeHandle::WipeHandle(Viewport& viewport) : QObject(&viewport), m_viewport(viewport) {
    viewport.setMouseTracking(true);
    viewport.installEventFilter(this);
    connect(&viewport, &Viewport::optionsChanged, this, [this] {
        if (!m_viewport.options().beforeAfter.wipe) {
            m_viewport.inspectTool().setOnWipeLine(false);
        }
    });
}

bool WipeHandle::isAt(const QMouseEvent& event) const {
    const BeforeAfterOptions& options = m_viewport.options().beforeAfter;
    const double line = static_cast<double>(options.wipeAt) * pictureWidth();
    return options.wipe && std::abs(event.position().x() - leftOfPicture(event) - line) <= kGrip;
}

double WipeHandle::pictureWidth() const {
    return std::max(m_viewport.options().sideBySide ? m_viewport.width() / 2 : m_viewport.width(), 1);
}

double WipeHandle::leftOfPicture(const QMouseEvent& event) const {
    const bool second = m_viewport.options().sideBySide && event.position().x() >= pictureWidth();
    return second ? pictureWidth() : 0.0;
}

bool WipeHandle::isCancelledBy(const QEvent& event) const {
    const bool isPress =
        event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
    return m_held && ((isPress && static_cast<const QMouseEvent&>(event).button() == Qt::RightButton) ||
                      (event.type() == QEvent::KeyPress &&
                       static_cast<const QKeyEvent&>(event).key() == Qt::Key_Escape));
}

bool WipeHandle::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_viewport || (!m_held && !m_viewport.options().beforeAfter.wipe)) {
        return false;
    }
    if (isCancelledBy(*event)) {
        m_held = false;
        Q_EMIT dragged(m_heldBefore);
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress) {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        m_held = mouse.button() == Qt::LeftButton && mouse.modifiers() == Qt::NoModifier && isAt(mouse);
        m_heldLeft = leftOfPicture(mouse);
        m_heldBefore = m_viewport.options().beforeAfter.wipeAt;
        return m_held;
    }
    if (event->type() == QEvent::MouseMove) {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        m_held = m_held && mouse.buttons().testFlag(Qt::LeftButton);  // another window may get the release
        if (m_held) {
            const double at = (mouse.position().x() - m_heldLeft) / pictureWidth();
            Q_EMIT dragged(static_cast<float>(std::clamp(at, 0.0, 1.0)));
            return true;
        }
        m_viewport.inspectTool().setOnWipeLine(isAt(mouse) && mouse.buttons() == Qt::NoButton);
        return false;
    }
    if (event->type() == QEvent::WindowBlocked) {
        m_held = false;
    }
    if (event->type() == QEvent::MouseButtonRelease && m_held) {
        m_held = false;
        return true;
    }
    return false;
}

}  // namespace hitscope
