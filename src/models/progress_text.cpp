// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/progress_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/remaining_time.h"

namespace hitscope {

QString withRemaining(const QString& what, double fraction, double seconds) {
    constexpr double kMinute = 60.0;
    constexpr double kInMinutes = 90.0;
    const std::optional<double> left = remainingSeconds(fraction, seconds);
    if (!left) {
        return what;
    }
    return *left > kInMinutes ? QCoreApplication::translate("hitscope::ProgressText", "%1, about %2 min left")
                                    .arg(what, QString::number(std::lround(*left / kMinute)))
                              : QCoreApplication::translate("hitscope::ProgressText", "%1, about %2 s left")
                                    .arg(what, QString::number(std::max(1L, std::lround(*left))));
}

}  // namespace hitscope
