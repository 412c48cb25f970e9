// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/usual_dent.h"

#include <algorithm>

#include "session/flight_mode.h"
#include "session/session.h"

namespace hitscope {

DeformationConstants usualConstants(const Session& session, const Hit& hit) {
    const SessionSettings& settings = session.settings();
    const Target* on = session.targets().find(hit.target);
    DeformationConstants constants = on != nullptr ? settings.constantsOn(*on) : settings.constants();
    if (settings.projectile().powerFollowsImpulse) {
        ConstantsSetting most = settings.constantsSetting();
        most.constants.power = static_cast<float>(deformationParameters()[kPower].maximum);
        const float cap = on != nullptr ? constantsOn(on->extent(), most).power : most.constants.power;
        const float power = constants.power * (hit.impulse / settings.projectile().referenceImpulse);
        constants.power = std::clamp(power, 0.0f, cap);
    }
    return constants;
}

DentForm usualForm(const Session& session, const Hit& hit, float radius) {
    return withRadius(session, session.settings().constantsSetting().form, hit, radius);
}

DentForm withRadius(const Session& session, DentForm form, const Hit& hit, float radius) {
    if (form.presses() && radius > 0.0f) {
        form.radius = radius;
    } else if (form.presses() && hit.form.radius > 0.0f) {
        form.radius = hit.form.radius;
    } else if (form.presses()) {
        const SessionSettings& settings = session.settings();
        const Target* on = session.targets().find(hit.target);
        form.radius = projectileOf(settings.flightMode(), settings.projectile(),
                                   on != nullptr ? on->extent() : kUsualExtent, 0.0f)
                          .radius;
    }
    return plain(form);
}

}  // namespace hitscope
