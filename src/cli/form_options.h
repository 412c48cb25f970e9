// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "deform/dent_form.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// --profile, --dent-direction and --curve.
[[nodiscard]] QList<UsageOption> formOptions();
/// What they say of the dents to come.
struct GivenForm {
    std::optional<DentProfile> profile;
    std::optional<DentDirection> direction;
    std::optional<CurveOrdinates> curve;

    [[nodiscard]] bool isAny() const { return profile || direction || curve; }
    /// A form with what is given, and otherwise as it is. One that presses has no profile: to give it one
    /// ends that.
    [[nodiscard]] DentForm over(DentForm form) const;
};
[[nodiscard]] GivenForm givenForm(Invocation& given);

}  // namespace hitscope::cli
