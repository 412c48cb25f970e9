// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/picture_motion.h"

#include <utility>

namespace hitscope {

PictureMotion::PictureMotion(QObject* parent) : QObject(parent) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(kRest);
    connect(&m_timer, &QTimer::timeout, this, &PictureMotion::rest);
}

void PictureMotion::moved() {
    m_timer.start();
}

float PictureMotion::beginFrame() {
    const bool moves = m_isOn && m_timer.isActive();
    const bool isFirst = std::exchange(m_isFirst, false) || !moves;
    m_scale = isFirst ? 1.0f : m_held.value_or(m_motion.scale());
    // A motion's first frame comes after a pause, and others may do as much meanwhile: its time is not
    // counted.
    m_isCounted = !isFirst;
    return m_scale;
}

void PictureMotion::frameShown(double seconds) {
    if (!m_timer.isActive()) {
        return;
    }
    if (std::exchange(m_isCounted, false)) {
        m_motion.frameTook(seconds);
    }
    m_timer.start();  // what drawing took is no rest
}

void PictureMotion::rest() {
    m_isFirst = true;
    if (isReduced()) {
        Q_EMIT rested();
    }
}

}  // namespace hitscope
