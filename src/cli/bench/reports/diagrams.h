// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bench/report.h"

class QXmlStreamWriter;

namespace hitscope::bench {

/// The diagrams of a report, as SVG with the classes that toHtml()'s style knows: lines over Report::along
/// where there is one, and a mark with its range for each row. All axes of times and ratios are logarithmic.
void writeDiagrams(QXmlStreamWriter& xml, const Report& report);

}  // namespace hitscope::bench
