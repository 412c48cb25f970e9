// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/picture_ahead.h"

#include <QElapsedTimer>
#include <utility>

namespace hitscope {

namespace {

constexpr int kLookApart = 1;    // milliseconds
constexpr qint64 kLongTurn = 5;  // milliseconds; then events are seen to before more is prepared

}  // namespace

PictureAhead::PictureAhead(Hooks hooks) : m_hooks(std::move(hooks)) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &PictureAhead::goOn);
}

void PictureAhead::setOn(bool on) {
    if (m_isOn == on) {
        return;
    }
    m_isOn = on;
    if (drawn()) {
        want();
    }
}

void PictureAhead::want() {
    if (!m_isOn) {
        m_hooks.paint();
        return;
    }
    m_isWanted = true;
    if (m_state == State::Nothing && !m_timer.isActive() && !m_isDue) {
        // Before anything is painted, while a timer without time would come after it.
        m_isDue = true;
        QMetaObject::invokeMethod(
            this,
            [this] {
                m_isDue = false;
                goOn();
            },
            Qt::QueuedConnection);
    }
}

void PictureAhead::drop() {
    if (m_state == State::Drawing) {
        m_state = State::Nothing;
        want();
    }
}

bool PictureAhead::drawn() {
    m_timer.stop();
    const bool wasWanted = m_isWanted || m_state == State::Drawing;
    m_state = State::Nothing;
    m_isWanted = false;
    return wasWanted;
}

void PictureAhead::shown() {
    if (m_state == State::Showing) {
        m_state = State::Nothing;
    }
    if (m_isWanted && m_state == State::Nothing) {
        m_timer.start(0);
    }
}

bool PictureAhead::prepare() {
    QElapsedTimer turn;
    turn.start();
    while (!m_hooks.prepare()) {
        if (turn.elapsed() >= kLongTurn) {
            return false;
        }
    }
    return true;
}

void PictureAhead::goOn() {
    if (m_state == State::Nothing && m_isWanted) {
        if (!prepare()) {
            m_timer.start(0);
            return;
        }
        m_isWanted = false;
        m_state = State::Drawing;  // whoever is told of it may want another one
        if (!m_hooks.begin()) {
            drawn();
            m_hooks.paint();
            return;
        }
        m_timer.start(kLookApart);
    } else if (m_state == State::Drawing) {
        if (!m_hooks.isFinished()) {
            m_timer.start(kLookApart);
            return;
        }
        m_state = State::Showing;
        if (!m_hooks.show()) {
            shown();
        }
    }
}

}  // namespace hitscope
