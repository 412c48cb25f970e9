// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "view/cutting_plane.h"

namespace hitscope::cli {

/// "x=0.1": a plane across x at 0.1 m that hides what lies beyond; "-x=0.1" hides the other side;
/// "1,1,0=0.5": across that direction, 0.5 m along it from the origin. Nothing: it is none of these.
[[nodiscard]] std::optional<CuttingPlane> parseCut(const QString& text);

}  // namespace hitscope::cli
