// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "cli/bench/bench_room.h"
#include "cli/command_line.h"
#include "cli/verbs.h"

namespace hitscope::bench {

// What is within `hitscope-cli bench`, in the order of help.
[[nodiscard]] cli::Verb paperVerb();
[[nodiscard]] cli::Verb frameVerb();
[[nodiscard]] cli::Verb modesVerb();
[[nodiscard]] cli::Verb hitVerb();
[[nodiscard]] cli::Verb physicsVerb();
[[nodiscard]] cli::Verb sessionVerb();
[[nodiscard]] cli::Verb ioVerb();
[[nodiscard]] cli::Verb latencyVerb();
[[nodiscard]] cli::Verb memoryVerb();
[[nodiscard]] cli::Verb checkVerb();
[[nodiscard]] cli::Verb compareReportsVerb();

/// What a benchmark puts into its report, which has its header already.
using Measuring = std::function<cli::Outcome(BenchRoom& room, Report& report)>;
/// Sees that the report can be written, opens a room with a picture of the options' size, measures, and
/// writes the report. `drawsPicture`: whether the header says its size. The outcome is that of `measuring`,
/// which may be cli::differs(), once the report is written.
[[nodiscard]] cli::Outcome runBenchmark(const QString& name, const CommonOptions& options, bool drawsPicture,
                                        const Measuring& measuring);

/// Of a benchmark that notes what it leaves out: good, or, where it has left out everything, the last reason.
[[nodiscard]] cli::Outcome whatCameOf(Report& report);
/// The note on a size that comes out as one that was measured: two rows of a report must not have the same
/// keys. `what`: "vertices".
[[nodiscard]] QString sameAgain(int wanted, const QString& what, std::size_t made);

}  // namespace hitscope::bench
