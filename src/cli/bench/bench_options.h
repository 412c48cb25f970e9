// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "cli/bench/arguments.h"
#include "cli/bench/harness.h"
#include "cli/bench/report.h"
#include "deform/pipeline_kind.h"
#include "usage/usage.h"

namespace hitscope::bench {

/// What the benchmarks have in common.
struct CommonOptions {
    Plan plan;
    Destinations destinations;
    std::vector<PipelineKind> pipelines;
    std::uint32_t seed = 1;
    int width = 16;   ///< pixels
    int height = 16;  ///< pixels
};

// Where a report goes: all that report take that.
[[nodiscard]] QList<UsageOption> destinationOptions();
[[nodiscard]] Destinations takeDestinations(Invocation& given);

// How long to measure as well: all that measure take that.
[[nodiscard]] QList<UsageOption> measuringOptions();
/// Invocation::error() says whether it is of use.
[[nodiscard]] CommonOptions takeMeasuringOptions(Invocation& given);

// How large a picture is.
[[nodiscard]] UsageOption sizeOption();
void takeSizeInto(CommonOptions& options, Invocation& given);

// Also which pipelines and hits.
[[nodiscard]] QList<UsageOption> commonOptions();
[[nodiscard]] CommonOptions takeCommonOptions(Invocation& given);

/// --strict; `what`: "a promise".
[[nodiscard]] UsageOption strictOption(const QString& what);

[[nodiscard]] inline QString pipelineName(PipelineKind kind) {
    return QString::fromUtf8(pipelineTraits(kind).name);
}
[[nodiscard]] inline QString pipelineKey(PipelineKind kind) {
    return QString::fromUtf8(pipelineTraits(kind).key);
}

}  // namespace hitscope::bench
