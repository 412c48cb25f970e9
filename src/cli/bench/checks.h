// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/bench/bench_room.h"
#include "cli/bench/harness.h"

namespace hitscope::bench {

/// One of the scenes, sizes or pipelines that a promise speaks of.
struct CheckRow {
    std::string where;  ///< "row 3"; empty: there is but one
    TimeRatio ratio;
};

/// A promise about speed, as a ratio of times measured in one run.
struct Check {
    std::string name;   ///< "history"
    std::string about;  ///< what over what
    double atMost;      ///< the ratio kept
    /// Measures it wherever it holds; no rows: nothing of it runs here. The error says why it cannot be
    /// measured though `needs` run.
    std::function<Result<std::vector<CheckRow>>(const BenchRoom&, const Plan&)> measure;
    std::vector<PipelineKind> needs{};  ///< pipelines that it is about
};

/// Picture size of the checks that draw, pixels.
inline constexpr int kCheckWidth = 320;
inline constexpr int kCheckHeight = 180;

/// All of them, in the order in which they are measured.
[[nodiscard]] std::span<const Check> allChecks();

}  // namespace hitscope::bench
