// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

namespace hitscope {

class SessionSettings;

/// The key that shoots at the crosshair: once when it is pressed, then at the projectile's rate of fire while
/// it is held. The crosshair shows meanwhile, and a moment longer.
class Trigger : public QObject {
    Q_OBJECT
public:
    explicit Trigger(SessionSettings& settings);  ///< which outlive it

    void press();
    void release() { m_repeatTimer.stop(); }
    /// Once, by whatever else.
    void pull();
    [[nodiscard]] bool showsCrosshair() const { return m_crosshairTimer.isActive(); }

Q_SIGNALS:
    void fired();
    void crosshairGone();

private:
    QTimer m_repeatTimer;
    QTimer m_crosshairTimer;
};

}  // namespace hitscope
