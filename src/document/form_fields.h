// SPDX-License-Identifier: GPL-3.0-or-later
// What of a DentForm is kept in a file: part of document_fields.h.
#pragma once

#include <algorithm>
#include <vector>

#include "deform/dent_form.h"

namespace hitscope {

/// Members of the object that has the form: those that are as usual are not written.
template <class Visit, class Form>
void visitForm(Visit& visit, Form& form) {
    if (Visit::reads() || form.profile != DentProfile::Paper) {
        visit.word("profile", form.profile, kDentProfileKeys);
    }
    if (Visit::reads() || form.direction != DentDirection::Projectile) {
        visit.word("dent_direction", form.direction, kDentDirectionKeys);
    }
    if (Visit::reads() || form.radius != 0.0f) {
        visit.number("press_radius", form.radius);
    }
    if constexpr (Visit::reads()) {
        if (!visit.has("curve")) {
            return;
        }
        std::vector<float> curve;
        visit.plain("curve", "ordinate", curve, kCurvePoints);
        const auto isShare = [](float ordinate) { return ordinate >= -1.0f && ordinate <= 1.0f; };
        if (curve.size() != kCurvePoints || !std::all_of(curve.begin(), curve.end(), isShare)) {
            visit.fail("curve", "has to be eight numbers from -1 to 1.");
            return;
        }
        std::copy(curve.begin(), curve.end(), form.curve.begin());
    } else if (form.curve != kUsualCurve) {
        visit.plain("curve", "ordinate", std::vector<float>(form.curve.begin(), form.curve.end()),
                    kCurvePoints);
    }
}

}  // namespace hitscope
