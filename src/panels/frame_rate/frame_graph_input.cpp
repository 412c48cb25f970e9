// SPDX-License-Identifier: GPL-3.0-or-later
// The hand on the frame graph: zoom, pan, reading a frame.

#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "panels/frame_rate/frame_graph.h"
#include "panels/plot/custom_plot.h"

namespace hitscope {

namespace {

constexpr double kLeastSeconds = 0.05;  // in sight
constexpr double kMostSeconds = 300.0;
constexpr double kZoomStep = 1.25;
constexpr double kPanStep = 0.1;  // of what is in sight

}  // namespace

void FrameGraph::zoom(double factor, double atX) {
    const double seconds = std::clamp(m_seconds * factor, kLeastSeconds, kMostSeconds);
    if (m_paused) {
        // What is under the mouse stays there.
        const double fromRight = -m_plot.xAxis->pixelToCoord(atX) - m_back;
        m_back = std::max(0.0, m_back + fromRight * (1.0 - seconds / m_seconds));
    }
    m_seconds = seconds;
    redraw();
}

void FrameGraph::pan(double seconds) {
    setPaused(true);
    const double oldest = frameCount() > 0 ? m_pausedAt - frame(0).end : 0.0;
    m_back = std::clamp(m_back + seconds, 0.0, std::max(0.0, oldest - 0.5 * m_seconds));
    redraw();
}

void FrameGraph::goLive() {
    m_seconds = kFirstSeconds;
    setPaused(false);
    redraw();
}

bool FrameGraph::handleKey(int key) {
    const double middle = m_plot.axisRect()->center().x();
    switch (key) {
        case Qt::Key_Plus:
            zoom(1.0 / kZoomStep, middle);
            return true;
        case Qt::Key_Minus:
            zoom(kZoomStep, middle);
            return true;
        case Qt::Key_Left:
            pan(kPanStep * m_seconds);
            return true;
        case Qt::Key_Right:
            pan(-kPanStep * m_seconds);
            return true;
        case Qt::Key_Home:
            goLive();
            return true;
        default:
            return false;
    }
}

bool FrameGraph::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::Wheel: {
            const auto* wheel = static_cast<QWheelEvent*>(event);
            zoom(std::pow(kZoomStep, -wheel->angleDelta().y() / 120.0), wheel->position().x());
            return true;
        }
        case QEvent::MouseButtonPress: {
            const auto* mouse = static_cast<QMouseEvent*>(event);
            if (mouse->button() == Qt::LeftButton) {
                m_dragX = mouse->position().x();
            }
            return false;
        }
        case QEvent::MouseMove: {
            const QPointF position = static_cast<QMouseEvent*>(event)->position();
            if (m_dragX && std::abs(position.x() - *m_dragX) >= 1.0) {
                pan((position.x() - *m_dragX) / std::max(1, m_plot.axisRect()->width()) * m_seconds);
                m_dragX = position.x();
            }
            m_mouse = position;
            hover(position);
            m_plot.replot(QCustomPlot::rpQueuedReplot);
            return false;
        }
        case QEvent::MouseButtonRelease:
            m_dragX.reset();
            return false;
        case QEvent::MouseButtonDblClick:
            goLive();
            return true;
        case QEvent::Leave:
            m_mouse.reset();
            endHover();
            m_plot.replot(QCustomPlot::rpQueuedReplot);
            return false;
        case QEvent::PaletteChange:
        case QEvent::FontChange:
            applyPalette();
            return false;
        case QEvent::KeyPress:
            return handleKey(static_cast<QKeyEvent*>(event)->key());
        default:
            return QObject::eventFilter(watched, event);
    }
}

void FrameGraph::hover(const QPointF& position) {
    if (!m_plot.axisRect()->rect().contains(position.toPoint())) {
        endHover();
        return;
    }
    const double now = present();
    const double time = now + m_plot.xAxis->pixelToCoord(position.x());
    std::size_t index = firstFrameEndingAfter(time);
    // The nearer of its neighbours.
    if (index == frameCount() || (index > 0 && frame(index - 1).number >= m_firstShown &&
                                  time - frame(index - 1).end < frame(index).end - time)) {
        --index;
    }
    if (index >= frameCount() || frame(index).number < m_firstShown) {
        endHover();
        return;
    }
    const FrameCost& nearest = frame(index);
    const bool isNew = !m_hovered || m_hovered->number != nearest.number || m_hovered->gpu != nearest.gpu;
    m_hovered = nearest;
    m_pointer->setVisible(true);
    m_pointer->point1->setCoords(nearest.end - now, 0.0);
    m_pointer->point2->setCoords(nearest.end - now, 1.0);
    if (isNew) {
        QToolTip::showText(m_plot.mapToGlobal(position.toPoint()), describe(nearest), &m_plot);
    }
}

void FrameGraph::endHover() {
    m_hovered.reset();
    m_pointer->setVisible(false);
    if (QToolTip::isVisible()) {
        QToolTip::hideText();
    }
}

}  // namespace hitscope
