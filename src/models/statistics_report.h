// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "models/statistics_rows.h"

namespace hitscope {

/// The mesh statistics to paste elsewhere. `title`: what was measured, "teapot".
/// Text: columns padded with spaces, numbers as the panel shows them.
[[nodiscard]] QString statisticsAsText(const QString& title, const MeshMeasurement& measurement);
/// A table for each section, numbers as the panel shows them.
[[nodiscard]] QString statisticsAsMarkdown(const QString& title, const MeshMeasurement& measurement);
/// RFC 4180, one header line, numbers with all digits and a decimal point whatever the locale:
/// section,key,property,unit,original,deformed,change,note. The note says why a number is missing.
[[nodiscard]] QString statisticsAsCsv(const MeshMeasurement& measurement);

}  // namespace hitscope
