// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "cli/bench/arguments.h"
#include "cli/bench/harness.h"
#include "cli/bench/report.h"
#include "deform/pipeline_kind.h"

namespace hitscope::bench {

/// What the benchmarks have in common.
struct CommonOptions {
    Plan plan;
    Destinations destinations;
    std::vector<PipelineKind> pipelines;
    std::uint32_t seed = 1;
    int width = 1280;  ///< pixels
    int height = 720;  ///< pixels
};

// How long to measure and where the report goes: all benchmarks take that.
void addMeasuringOptions(Arguments& arguments);
/// arguments.error() says whether it is of use.
[[nodiscard]] CommonOptions takeMeasuringOptions(Arguments& arguments);

// Also which pipelines and hits and, `withPicture`, how large.
void addCommonOptions(Arguments& arguments, bool withPicture);
[[nodiscard]] CommonOptions takeCommonOptions(Arguments& arguments, bool withPicture);

/// arguments.parse() with what may stand alone here.
void parseBenchArguments(Arguments& arguments, const QStringList& list);

[[nodiscard]] inline QString pipelineName(PipelineKind kind) {
    return QString::fromUtf8(pipelineTraits(kind).name);
}
[[nodiscard]] inline QString pipelineKey(PipelineKind kind) {
    return QString::fromUtf8(pipelineTraits(kind).key);
}

}  // namespace hitscope::bench
