// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/trigger.h"

#include "session/session_settings.h"

namespace hitscope {

namespace {

constexpr int kCrosshairStays = 1500;  // milliseconds after the last shot

}  // namespace

Trigger::Trigger(SessionSettings& settings) {
    m_crosshairTimer.setSingleShot(true);
    m_crosshairTimer.setInterval(kCrosshairStays);
    connect(&m_crosshairTimer, &QTimer::timeout, this, &Trigger::crosshairGone);
    connect(&m_repeatTimer, &QTimer::timeout, this, &Trigger::pull);
    const auto followRateOfFire = [this, &settings] {
        m_repeatTimer.setInterval(qRound(1000.0f / settings.projectile().rateOfFire));
    };
    followRateOfFire();
    connect(&settings, &SessionSettings::projectileChanged, this, followRateOfFire);
}

void Trigger::press() {
    pull();
    m_repeatTimer.start();
}

void Trigger::pull() {
    m_crosshairTimer.start();
    Q_EMIT fired();
}

}  // namespace hitscope
