// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/wipe_handle.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "viewport/viewport.h"

namespace hitscope {

WipeHandle::WipeHandle(Viewport& viewport) : QObject(&viewport), m_viewport(viewport) {
    viewport.setMouseTracking(true);
    viewport.installEventFilter(this);
}

bool WipeHandle::isAt(const QMouseEvent& event) const {
    const BeforeAfterOptions& options = m_viewport.options().beforeAfter;
    const double line = static_cast<double>(options.wipeAt) * m_viewport.width();
    return options.wipe && std::abs(event.position().x() - line) <= kGrip;
}

bool WipeHandle::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_viewport || (!m_held && !m_viewport.options().beforeAfter.wipe)) {
        return false;
    }
    if (event->type() == QEvent::MouseButtonPress) {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        m_held = mouse.button() == Qt::LeftButton && mouse.modifiers() == Qt::NoModifier && isAt(mouse);
        return m_held;
    }
    if (event->type() == QEvent::MouseMove) {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        if (m_held) {
            const double at = mouse.position().x() / std::max(m_viewport.width(), 1);
            Q_EMIT dragged(static_cast<float>(std::clamp(at, 0.0, 1.0)));
            return true;
        }
        const bool hovered = isAt(mouse) && mouse.buttons() == Qt::NoButton;
        if (hovered != m_hovered) {
            m_hovered = hovered;
            hovered ? m_viewport.setCursor(Qt::SplitHCursor) : m_viewport.unsetCursor();
        }
        return false;
    }
    if (event->type() == QEvent::MouseButtonRelease && m_held) {
        m_held = false;
        return true;
    }
    return false;
}

}  // namespace hitscope
