// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "deform/dent_form.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// --profile, --dent-direction and --curve.
[[nodiscard]] QList<UsageOption> formOptions();
/// What they say of the dents to come; nothing: none of them is there.
[[nodiscard]] std::optional<DentForm> givenForm(Invocation& given);

}  // namespace hitscope::cli
