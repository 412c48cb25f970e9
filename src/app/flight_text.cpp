// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/flight_text.h"

#include <QCoreApplication>
#include <cmath>

#include "models/focus_target.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

struct FlightText {
    Q_DECLARE_TR_FUNCTIONS(hitscope::FlightText)
};

/// To three digits.
QString shortNumber(float value) {
    if (!(value > 0.0f)) {
        return shownFloat(value);
    }
    const double unit = std::pow(10.0, std::floor(std::log10(static_cast<double>(value))) - 2.0);
    return shownFloat(static_cast<float>(std::round(static_cast<double>(value) / unit) * unit));
}

}  // namespace

QString flightText(const Session& session) {
    const Target* target = focusTarget(session);
    const float extent = target != nullptr ? target->extent() : kUsualExtent;
    const ProjectileSettings shot =
        projectileOf(session.settings().flightMode(), session.settings().projectile(), extent, 0.0f);
    switch (session.settings().flightMode()) {
        case FlightMode::Instant:
            return FlightText::tr("No flight: the hit is where the line of sight ends.");
        case FlightMode::Quick:
            return FlightText::tr(
                       "Radius %1 m and gravity %2 m/s², by the size of the target (%3 m). The speed "
                       "follows the distance: a flight takes %4 s. Lifetime %5 s.")
                .arg(shortNumber(shot.radius), shortNumber(shot.gravity), shortNumber(extent),
                     shortNumber(kQuickFlight), shortNumber(shot.lifetime));
        case FlightMode::Paper:
        case FlightMode::Own:
            break;
    }
    return FlightText::tr("Speed %1 m/s, radius %2 m, lifetime %3 s, gravity %4 m/s².")
        .arg(shortNumber(shot.speed), shortNumber(shot.radius), shortNumber(shot.lifetime),
             shortNumber(shot.gravity));
}

}  // namespace hitscope
