// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

#include "bench_window/driven_window.h"

namespace hitscope::bench {

/// Opens `mesh` in the window, makes `hits` small hits of about 80 vertices one after the other, undoes all,
/// and closes the scene; says what the window has in memory after each. {"vertices", "hits", "moved":
/// vertices a hit, "worker": bytes at most, "rows": [{"measured", "share", "resident"}]}, bytes.
/// window.error() says what went wrong.
[[nodiscard]] QJsonObject measureMemory(DrivenWindow& window, const QString& mesh, int hits);

}  // namespace hitscope::bench
