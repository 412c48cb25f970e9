// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <string>

#include "pipeline/pipeline_kind.h"

namespace hitscope::test {

/// A row of test data for each pipeline, with an int `kind`.
inline void addPipelines() {
    QTest::addColumn<int>("kind");
    for (const PipelineTraits& traits : allPipelines()) {
        QTest::addRow("%s", std::string(traits.key).c_str()) << static_cast<int>(traits.kind);
    }
}

}  // namespace hitscope::test
