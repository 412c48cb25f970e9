// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/frame_rate_read_out.h"

#include "app/status_line.h"
#include "panels/frame_rate/frame_rate_panel.h"
#include "session/frame_costs.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kInterval = 500;  // milliseconds

}  // namespace

FrameRateReadOut::FrameRateReadOut(FrameRatePanel& frames, Viewport& viewport, StatusLine& status,
                                   QObject* parent)
    : QObject(parent), m_frames(frames), m_viewport(viewport), m_status(status) {
    m_timer.setInterval(kInterval);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (!m_viewport.pictures().refiner().isUnderWay()) {
            follow();
        }
    });
    connect(&viewport.pictures().refiner(), &PictureRefiner::aboutToShow, this, &FrameRateReadOut::follow);
    connect(&viewport.session().frameCosts(), &FrameCosts::frameEnded, this, [this] {
        if (!m_timer.isActive()) {
            m_timer.start();
        }
    });
}

void FrameRateReadOut::follow() {
    const FrameTimes::Summary summary = m_frames.summary();
    m_status.setFrameRate(summary, m_viewport.pictures().motion().seenDetail());
    if (summary.recent == 0) {
        m_timer.stop();  // until the next frame
    }
}

}  // namespace hitscope
