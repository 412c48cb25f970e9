// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "deform/pipeline_kind.h"

namespace hitscope::cli {

/// What --pipeline takes, in the order of allPipelines().
[[nodiscard]] QStringList pipelineWords();
/// Nothing: none has that name.
[[nodiscard]] std::optional<PipelineKind> pipelineNamed(const QString& word);

}  // namespace hitscope::cli
