// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <optional>
#include <string>

#include "deform/pipeline_kind.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/measure_exactness.h"

/// In a test function with a context: skips the row, with the reason, where this renderer lacks what that
/// pipeline needs.
#define HITSCOPE_NEEDS_PIPELINE(kind)                                                  \
    do {                                                                               \
        if (const std::optional<std::string> why =                                     \
                hitscope::whyUnavailable(static_cast<hitscope::PipelineKind>(kind))) { \
            QSKIP(why->c_str());                                                       \
        }                                                                              \
    } while (false)

/// In initTestCase() with a context, or in a test function: skips what compares bits with the reference where
/// the renderer's arithmetic is not exact, and says by how much. ExactnessTest holds a renderer to be exact
/// that is known to be.
#define HITSCOPE_NEEDS_EXACT_ARITHMETIC()                                          \
    do {                                                                           \
        if (const std::string why = hitscope::test::whyNotExact(); !why.empty()) { \
            QSKIP(why.c_str());                                                    \
        }                                                                          \
    } while (false)

namespace hitscope::test {

/// Empty: this renderer is exact, with the variant of deform.glsl that it needs. A context is current.
[[nodiscard]] inline std::string whyNotExact() {
    const Result<Exactness> measured = measureExactness();
    return !measured || measured.value().isExact() ? std::string()
                                                   : "this renderer is " + describe(measured.value());
}

/// For programs that include deform.glsl: the variant that this renderer needs, as the window uses it. A
/// context is current.
[[nodiscard]] inline gl::Defines deformDefines() {
    const Result<Exactness> measured = measureExactness();
    return measured ? definesOf(measured.value()) : gl::Defines();
}

/// For makePipeline(), with deformDefines().
[[nodiscard]] inline PipelineOptions pipelineOptions() {
    PipelineOptions options;
    options.deformDefines = deformDefines();
    return options;
}

/// A row of test data for each pipeline, with an int `kind`.
inline void addPipelines() {
    QTest::addColumn<int>("kind");
    for (const PipelineTraits& traits : allPipelines()) {
        QTest::addRow("%s", std::string(traits.key).c_str()) << static_cast<int>(traits.kind);
    }
}

}  // namespace hitscope::test
