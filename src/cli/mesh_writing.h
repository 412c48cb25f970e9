// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "cli/command_line.h"
#include "session/export/export_options.h"
#include "session/session.h"
#include "usage/invocation.h"

namespace hitscope::cli {

// What export and convert have in common.

/// --format, --normals, --all-normals, --check
[[nodiscard]] QList<UsageOption> writingOptions();
/// What --format says, or else the suffix; a complaint where neither does.
[[nodiscard]] ExportOptions givenWriting(Invocation& given, const QString& path);
/// Writes targets of the session into one file, or to the standard output, and reports.
[[nodiscard]] Outcome writeTargets(Invocation& given, const Session& session,
                                   const std::vector<const Target*>& targets, const ExportOptions& options,
                                   const QString& path);

}  // namespace hitscope::cli
