// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/paced_advance.h"

#include <algorithm>
#include <chrono>

#include "session/session.h"

namespace hitscope {

double paceClock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::function<bool()> timeLimit(double most) {
    return [begin = paceClock(), most] { return paceClock() - begin >= most; };
}

std::function<bool()> workLimit(int looks) {
    return [left = looks]() mutable { return --left <= 0; };
}

void advanceWithin(Session& session, double seconds, double most, const PaceClock& clock) {
    const double aStep =
        session.simulation().physics().clock().step() / session.simulation().physics().clock().timeScale();
    const double begin = clock();
    const auto isTimeUp = [&] { return clock() - begin >= most; };
    double left = seconds;
    do {
        session.simulation().advance(std::min(left, aStep), isTimeUp);
        left -= aStep;
    } while (left > 0.0 && !isTimeUp());
}

}  // namespace hitscope
