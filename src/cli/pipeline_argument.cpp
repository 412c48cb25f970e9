// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/pipeline_argument.h"

namespace hitscope::cli {

QStringList pipelineWords() {
    QStringList words;
    for (const PipelineTraits& traits : allPipelines()) {
        words << QString::fromUtf8(traits.key);
    }
    return words;
}

std::optional<PipelineKind> pipelineNamed(const QString& word) {
    const qsizetype place = pipelineWords().indexOf(word);
    return place < 0 ? std::nullopt : std::optional(allPipelines()[static_cast<std::size_t>(place)].kind);
}

}  // namespace hitscope::cli
