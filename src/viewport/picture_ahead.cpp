// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/picture_ahead.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace hitscope {

namespace {

constexpr int kLookApart = 1;  // milliseconds

}  // namespace

PictureAhead::PictureAhead(QWidget& widget, Hooks hooks) : m_widget(widget), m_hooks(std::move(hooks)) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kLookApart);
    connect(&m_timer, &QTimer::timeout, this, &PictureAhead::look);
}

void PictureAhead::setOn(bool on) {
    m_isOn = on;
    if (!on) {
        drop();
    }
}

void PictureAhead::want() {
    if (m_isOn && m_window != m_widget.window()) {
        if (m_window) {
            m_window->removeEventFilter(this);
        }
        m_window = m_widget.window();
        m_window->installEventFilter(this);
    }
    m_isWanted = true;
    m_widget.update();
}

PictureAhead::Shown PictureAhead::take(bool byWindow, bool hasLast) {
    const State state = std::exchange(m_state, State::Nothing);
    m_timer.stop();
    if (state == State::Showing) {
        return Shown::Ahead;
    }
    if (state == State::Drawing) {
        askToPaint();  // its request was held back, and this may be for a picture of the widget alone
    }
    if (m_isOn && byWindow && hasLast && !m_isUnable) {
        m_isWanted = true;
        if (state == State::Nothing) {
            askToPaint();
        }
        return Shown::Last;
    }
    m_isWanted = false;
    return Shown::Itself;
}

void PictureAhead::drop() {
    if (m_state == State::Drawing) {
        m_timer.stop();
        m_state = State::Nothing;
        m_isWanted = true;
        askToPaint();
    }
}

void PictureAhead::shown() {
    if (m_isWanted) {
        m_widget.update();
    }
}

void PictureAhead::look() {
    if (m_state == State::Drawing && !m_hooks.isFinished()) {
        return;
    }
    m_timer.stop();
    if (m_state == State::Drawing) {
        askToPaint();
    }
}

/// What Qt itself sends only once until the window has painted itself.
void PictureAhead::askToPaint() {
    m_widget.update();
    if (m_window) {
        QCoreApplication::postEvent(m_window, new QEvent(QEvent::UpdateRequest), Qt::LowEventPriority);
    }
}

bool PictureAhead::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::UpdateRequest || watched != m_window) {
        return QObject::eventFilter(watched, event);
    }
    if (m_state == State::Drawing) {
        if (m_timer.isActive()) {
            return true;
        }
        m_state = State::Showing;
        watched->event(event);
        if (m_state == State::Showing) {  // the window has not painted the widget
            m_state = State::Nothing;
        }
        return true;
    }
    if (!m_isOn || !m_widget.isVisible() || !std::exchange(m_isWanted, false)) {
        return false;
    }
    if (!m_hooks.begin()) {
        m_isUnable = true;
        watched->event(event);
        m_isUnable = false;
        return true;
    }
    m_state = State::Drawing;
    m_timer.start();
    return true;
}

}  // namespace hitscope
