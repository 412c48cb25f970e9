// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace hitscope {

class Session;

/// Seconds after which a frame's physics begins nothing more: with the shot or the part of a step that is
/// under way then, a frame is held up for no more than 16 ms.
inline constexpr double kMostPhysics = 0.010;

/// Seconds on a clock that does not go back.
using PaceClock = std::function<double()>;
[[nodiscard]] double paceClock();
/// Says whether `most` seconds have gone by since this was called.
[[nodiscard]] std::function<bool()> timeLimit(double most = kMostPhysics);
/// Says so from the look numbered `looks` on, whatever the machine: for what must come out the same on all.
[[nodiscard]] std::function<bool()> workLimit(int looks = 64);

/// session.simulation().advance(seconds), but no step is begun, and no shot that is due is fired, once `most`
/// seconds have gone by: the rest of the time is dropped, so that the scene slows down and not the window,
/// and the next frame has nothing to catch up with. One shot or step is always taken that is due. Hits depend
/// on the steps alone, so they are the same.
void advanceWithin(Session& session, double seconds, double most = kMostPhysics,
                   const PaceClock& clock = paceClock);

}  // namespace hitscope
