// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <cstdint>

#include "session/shots/shot_script.h"

class QSettings;

namespace hitscope {

class Viewport;

/// A series of shots from where the camera is, as a person asks for it.
struct ShotSeries {
    enum class Pattern : std::uint8_t {
        Burst,   ///< spread over a cone about the middle of the view
        Line,    ///< from one place of the view to another
        Circle,  ///< around the middle of the view
    };
    Pattern pattern = Pattern::Burst;
    int count = 20;
    double interval = 0.0;    ///< seconds of simulated time between shots; 0: one volley
    double angle = 5.0;       ///< degrees from the middle: of the cone's edge, of the circle
    std::uint32_t seed = 1;   ///< of a burst
    QPointF from{0.25, 0.5};  ///< of a line; fractions of the view from its top left corner
    QPointF to{0.75, 0.5};
    bool isInstant = false;

    static constexpr int kMostShots = 5000;
    static constexpr double kLongestInterval = 10.0;
    static constexpr double kWidest = 89.0;
};

/// The shots of a series from where the viewport's camera is now, with the projectile that a click in the
/// middle of the view would shoot; none is removed for the sake of those after it. Shots in flight are raised
/// so that they land where they are aimed at. Instant where the session's flight mode is.
[[nodiscard]] ShotScript makeScript(const ShotSeries& series, const Viewport& viewport);

/// What was never saved, or is out of range, is as in ShotSeries().
[[nodiscard]] ShotSeries loadShotSeries(const QSettings& settings, ShotSeries::Pattern pattern);
void saveShotSeries(QSettings& settings, const ShotSeries& series);

}  // namespace hitscope
