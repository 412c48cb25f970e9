// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/frame_rate_text.h"

#include <QCoreApplication>

#include "models/quantity_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("hitscope::FrameRate", text);
}

}  // namespace

QString frameTimeText(double seconds) {
    if (seconds >= 0.9995) {
        return tr("%1 s").arg(shownNumber(seconds, 'f', 1));
    }
    return tr("%1 ms").arg(shownNumber(seconds * kMilliseconds, 'f', seconds < 0.0995 ? 1 : 0));
}

QString frameRateText(const FrameTimes::Summary& summary) {
    if (summary.recent == 0) {
        return summary.lastCost > 0.0 ? tr("Idle · last frame %1").arg(frameTimeText(summary.lastCost))
                                      : tr("Idle");
    }
    const int decimals = summary.framesPerSecond < 9.95 ? 1 : 0;
    return tr("%1 (%2 FPS)")
        .arg(frameTimeText(summary.recentCost), shownNumber(summary.framesPerSecond, 'f', decimals));
}

}  // namespace hitscope
