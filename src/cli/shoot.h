// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "core/result.h"

namespace hitscope::cli {

struct ShootOptions {
    QString meshPath;    ///< empty: the paper's scene
    QString scriptPath;  ///< empty: a burst
    int burst = 20;
    double cone = 5.0;  ///< degrees from its middle to its edge
    unsigned seed = 1;
    double interval = 0.0;   ///< seconds between the burst's shots
    bool isInstant = false;  ///< the burst's; a script says so itself
    QString savePath;        ///< where the script goes; empty: nowhere
};

/// Shoots a script, or a burst at the middle of the scene from where all of it is seen, with no display;
/// prints what was hit and a number that is the same for the same hits, in every bit.
[[nodiscard]] Status runShoot(const ShootOptions& options);

/// hitscope-cli shoot; returns the exit status.
int shootCommand(const QStringList& arguments);

}  // namespace hitscope::cli
