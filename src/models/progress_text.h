// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace hitscope {

/// `what`, with about how long it still takes where that can be told: `fraction` of it, [0, 1], took
/// `seconds`.
[[nodiscard]] QString withRemaining(const QString& what, double fraction, double seconds);

}  // namespace hitscope
