// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/cost_measurement.h"

namespace hitscope {

/// Measures in an OpenGL context of its own, without a window: the pipelines in turn, each sample until the
/// GPU is done.
[[nodiscard]] CostMeter costMeter();

}  // namespace hitscope
