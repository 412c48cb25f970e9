// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>
#include <span>
#include <string_view>

#include "cli/command_line.h"
#include "cli/json_report.h"
#include "deform/pipeline_kind.h"
#include "usage/invocation.h"

namespace hitscope::cli {

// Options that several verbs take alike.

/// Keys of files, by which an option takes its words.
[[nodiscard]] QStringList wordsOf(std::span<const std::string_view> keys);

/// --quiet
[[nodiscard]] UsageOption quietOption();
/// --json, --report and --quiet, of verbs that report.
[[nodiscard]] QList<UsageOption> reportOptions();
/// --pipeline; `standard` says in words what is taken without it.
[[nodiscard]] UsageOption pipelineOption(const QString& standard);
/// What --pipeline names; nothing: it is not there.
[[nodiscard]] std::optional<PipelineKind> givenPipeline(Invocation& given);
/// --target
[[nodiscard]] UsageOption targetOption(const QString& standard);

/// --out as the file for a mesh, whose suffix says the format; complains about others. Empty: it is not
/// there.
[[nodiscard]] QString givenMeshFile(Invocation& given);

/// The text to the standard output, or, with --json, the report; and the report into --report's file.
[[nodiscard]] Status giveReport(const Invocation& given, JsonReport& report, const QString& text);

/// "x,y,z" of finite numbers; nothing: it is none.
[[nodiscard]] std::optional<glm::vec3> vectorOf(const QString& text);

}  // namespace hitscope::cli
