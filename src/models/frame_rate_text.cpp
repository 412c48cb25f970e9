// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/frame_rate_text.h"

#include <QCoreApplication>

#include "models/quantity_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

struct FrameRateTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::FrameRate)
};

}  // namespace

QString frameTimeText(double seconds) {
    if (seconds >= 0.9995) {
        return FrameRateTexts::tr("%1 s").arg(shownNumber(seconds, 'f', 1));
    }
    return FrameRateTexts::tr("%1 ms").arg(
        shownNumber(seconds * kMilliseconds, 'f', seconds < 0.0995 ? 1 : 0));
}

QString frameRateText(const FrameTimes::Summary& summary, const PictureDetail& detail) {
    if (summary.recent == 0) {
        return summary.lastCost > 0.0
                   ? FrameRateTexts::tr("Idle · last frame %1").arg(frameTimeText(summary.lastCost))
                   : FrameRateTexts::tr("Idle");
    }
    const int decimals = summary.framesPerSecond < 9.95 ? 1 : 0;
    const QString text =
        FrameRateTexts::tr("%1 (%2 FPS)")
            .arg(frameTimeText(summary.recentCost), shownNumber(summary.framesPerSecond, 'f', decimals));
    const int percent = qRound(100.0f * detail.scale);
    if (detail.scale < 1.0f) {
        return (detail.coarse ? FrameRateTexts::tr("%1, drawn at %2 % size with fewer triangles")
                              : FrameRateTexts::tr("%1, drawn at %2 % size"))
            .arg(text)
            .arg(percent);
    }
    return detail.coarse ? FrameRateTexts::tr("%1, drawn with fewer triangles").arg(text) : text;
}

}  // namespace hitscope
