// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "deform/dent_form.h"

namespace hitscope {

/// By its key in kDentProfileKeys, kDentDirectionKeys; nothing: no such key.
[[nodiscard]] std::optional<DentProfile> profileNamed(std::string_view key);
[[nodiscard]] std::optional<DentDirection> directionNamed(std::string_view key);
[[nodiscard]] std::string_view keyOf(DentProfile profile);
[[nodiscard]] std::string_view keyOf(DentDirection direction);

/// "1,0.95,0.8,…": the ordinates with as many digits as bring the same bits back, `separator` between them.
[[nodiscard]] std::string curveText(const CurveOrdinates& curve, char separator = ',');
/// Eight numbers in [-1, 1]; nothing: it is something else.
[[nodiscard]] std::optional<CurveOrdinates> curveFrom(std::string_view text, char separator = ',');

}  // namespace hitscope
