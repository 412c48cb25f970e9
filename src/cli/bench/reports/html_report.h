// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "cli/bench/report.h"

namespace hitscope::bench {

/// The report as a page of HTML that needs nothing else: header, diagrams (SVG, no scripts), tables, notes;
/// dark where the reader's system is. It is well-formed XML. UTF-8.
[[nodiscard]] QByteArray toHtml(const Report& report);

}  // namespace hitscope::bench
