// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/dent_form_names.h"

#include <QCoreApplication>

#include "session/shown_number.h"

namespace hitscope {

namespace {

struct DentFormNames {
    Q_DECLARE_TR_FUNCTIONS(DentForm)
};

}  // namespace

QString nameOf(DentProfile profile) {
    switch (profile) {
        case DentProfile::Paper:
            return DentFormNames::tr("Paper");
        case DentProfile::Smooth:
            return DentFormNames::tr("Smooth");
        case DentProfile::Wendland:
            return DentFormNames::tr("Wendland C2");
        case DentProfile::Linear:
            return DentFormNames::tr("Linear");
        case DentProfile::Crater:
            return DentFormNames::tr("Crater");
        case DentProfile::Curve:
            return DentFormNames::tr("Free curve");
    }
    return {};
}

QString nameOf(DentDirection direction) {
    switch (direction) {
        case DentDirection::Projectile:
            return DentFormNames::tr("As it flew");
        case DentDirection::IntoSurface:
            return DentFormNames::tr("Into the surface");
        case DentDirection::Press:
            return DentFormNames::tr("Press");
    }
    return {};
}

QString nameOf(const DentForm& form) {
    if (form.presses()) {
        return DentFormNames::tr("Press, radius %1 m").arg(shownFloat(form.radius));
    }
    return form.direction == DentDirection::IntoSurface
               ? DentFormNames::tr("%1, into the surface").arg(nameOf(form.profile))
               : nameOf(form.profile);
}

}  // namespace hitscope
