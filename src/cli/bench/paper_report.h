// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bench/paper_row.h"

namespace hitscope::bench {

/// A row as measured, with one texture.
struct MeasuredRow {
    int row = 0;      ///< index into paperRows()
    QString texture;  ///< "none", "1k" ...
    std::vector<RowFigure> figures;
};

/// Adds the rows' figures to a report: for each texture (in the order they come) a table a pipeline in the
/// paper's layout and one of the ratios; and the records.
void addPaperRows(Report& report, const std::vector<MeasuredRow>& rows);

}  // namespace hitscope::bench
