// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/form_options.h"

#include "cli/common_options.h"
#include "deform/dent_form_text.h"

namespace hitscope::cli {

QList<UsageOption> formOptions() {
    return {
        wordOption("profile", "NAME", wordsOf(kDentProfileKeys),
                   QStringLiteral("Fall-off profile: how far vertices move as a function of their distance "
                                  "from the hit. Default: the session's, or paper.")),
        wordOption("dent-direction", "NAME", wordsOf(kDentDirectionKeys),
                   QStringLiteral("Direction in which vertices move: along the projectile's flight, into the "
                                  "surface (against its normal), or out of the projectile's sphere (press). "
                                  "Default: the session's, or projectile.")),
        valueOption(
            "curve", "NUMBERS",
            QStringLiteral(
                "Curve of --profile curve, which it implies: eight numbers from -1 to 1, separated by "
                "commas, from the hit to max_distance, as fractions of max_magnitude."))};
}

DentForm GivenForm::over(DentForm form) const {
    form.profile = profile.value_or(form.profile);
    form.curve = curve.value_or(form.curve);
    form.direction =
        direction.value_or(profile && form.presses() ? DentDirection::Projectile : form.direction);
    return plain(form);
}

GivenForm givenForm(Invocation& given) {
    GivenForm form;
    if (given.isSet("profile")) {
        form.profile = static_cast<DentProfile>(given.word("profile"));
    }
    if (given.isSet("dent-direction")) {
        form.direction = static_cast<DentDirection>(given.word("dent-direction"));
    }
    if (form.direction == DentDirection::Press && (given.isSet("profile") || given.isSet("curve"))) {
        given.complain(
            QStringLiteral("--dent-direction press has the projectile's shape, and takes no --profile."));
    }
    if (given.isSet("curve")) {
        const auto curve = curveFrom(given.text("curve").toStdString());
        if (!curve) {
            given.complain(QStringLiteral("--curve takes eight numbers from -1 to 1 with commas between."));
        }
        if (form.profile && form.profile != DentProfile::Curve) {
            given.complain(QStringLiteral("--curve needs --profile curve."));
        }
        form.curve = curve.value_or(kUsualCurve);
        form.profile = DentProfile::Curve;
    }
    return form;
}

}  // namespace hitscope::cli
