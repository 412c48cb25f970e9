// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <optional>
#include <string>

#include "pipeline/deformation_pipeline.h"
#include "pipeline/pipeline_kind.h"

/// In a test function with a context: skips the row, with the reason, where this renderer lacks what that
/// pipeline needs.
#define HITSCOPE_NEEDS_PIPELINE(kind)                                                  \
    do {                                                                               \
        if (const std::optional<std::string> why =                                     \
                hitscope::whyUnavailable(static_cast<hitscope::PipelineKind>(kind))) { \
            QSKIP(why->c_str());                                                       \
        }                                                                              \
    } while (false)

namespace hitscope::test {

/// A row of test data for each pipeline, with an int `kind`.
inline void addPipelines() {
    QTest::addColumn<int>("kind");
    for (const PipelineTraits& traits : allPipelines()) {
        QTest::addRow("%s", std::string(traits.key).c_str()) << static_cast<int>(traits.kind);
    }
}

}  // namespace hitscope::test
