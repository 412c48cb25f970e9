// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cli/bench/checks.h"
#include "cli/bench/report.h"

namespace hitscope::bench {

/// Measures these and puts them into an empty report: a row for each scene, size or pipeline that a promise
/// speaks of. Whether all are kept. A promise that could not be measured is not, unless it is of a pipeline
/// that does not run here.
[[nodiscard]] Result<bool> reportChecks(std::span<const Check> checks, const BenchRoom& room,
                                        const Plan& plan, Report& report);

}  // namespace hitscope::bench
