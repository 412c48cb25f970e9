// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "core/result.h"
#include "session/flight_mode.h"

namespace hitscope::cli {

struct ShootOptions {
    QString meshPath;    ///< empty: the paper's scene
    QString scriptPath;  ///< empty: a burst
    int burst = 20;
    double cone = 5.0;  ///< degrees from its middle to its edge
    unsigned seed = 1;
    double interval = 0.0;  ///< seconds between the burst's shots
    /// How the burst flies; a script says so itself. Nothing: as in the paper at the paper's scene, quick at
    /// a mesh, which may be of any size.
    std::optional<FlightMode> flight;
    QString savePath;  ///< where the script goes; empty: nowhere
};

/// Shoots a script, or a burst at the middle of the scene from where all of it is seen, with no display;
/// prints what was hit and a number that is the same for the same hits, in every bit.
[[nodiscard]] Status runShoot(const ShootOptions& options);

/// hitscope-cli shoot; returns the exit status.
int shootCommand(const QStringList& arguments);

}  // namespace hitscope::cli
