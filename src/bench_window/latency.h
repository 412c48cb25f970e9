// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

#include "bench_window/driven_window.h"

namespace hitscope::bench {

/// How often each thing is done: until there are `most`, or, once there are `least`, `seconds` have passed.
struct Repeats {
    int least = 3;
    int most = 10;
    double seconds = 2.0;
    int scattered = 10'000;  ///< hits; 0: none are
};

/// Opens `mesh` in the window, shoots, undoes, orbits, aims, exports and scatters, and measures what a person
/// waits for. {"vertices", "moved": vertices that a click moves, "viewport": [width, height], "rows":
/// [{"measured", "seconds": [...], "blocked": [...], "processor": [...]}]}. window.error() says what went
/// wrong.
[[nodiscard]] QJsonObject measureLatency(DrivenWindow& window, const QString& mesh, const Repeats& repeats);

}  // namespace hitscope::bench
