// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <cstdint>

#include "cli/bench/report.h"

namespace hitscope::bench {

/// A report as a file has it, and where it was.
struct ReportFile {
    QString path;
    QByteArray json;
};

struct ComparisonRules {
    double confidence = 0.99;  ///< of the intervals, (0.5, 1)
    double tolerance = 0.05;   ///< what part slower does not count, >= 0
};

struct ReportComparison {
    Report report;       ///< a row for each that both have
    int slowerRows = 0;  ///< more than the tolerance slower, with that confidence
};

/// What `b` takes over what `a` takes, row by row. The error names the file and what is wrong with it: no
/// report, no runs kept, of another benchmark, no row in common.
[[nodiscard]] Result<ReportComparison> compareReports(const ReportFile& a, const ReportFile& b,
                                                      const ComparisonRules& rules);

}  // namespace hitscope::bench
