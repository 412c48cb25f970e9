// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "analysis/comparison.h"

namespace hitscope {

/// What a comparison of pipelines has found, in a line or two; empty: there is none.
[[nodiscard]] QString comparisonText(const Comparison& comparison);

}  // namespace hitscope
