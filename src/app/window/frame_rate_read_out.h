// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

namespace hitscope {

class FrameRatePanel;
class StatusLine;
class Viewport;

/// The frame rate in the status bar. Looked up some times a second while frames come, never otherwise.
class FrameRateReadOut : public QObject {
    Q_OBJECT
public:
    /// All outlive this, but `parent`.
    FrameRateReadOut(FrameRatePanel& frames, Viewport& viewport, StatusLine& status, QObject* parent);

private:
    void follow();

    FrameRatePanel& m_frames;
    Viewport& m_viewport;
    StatusLine& m_status;
    QTimer m_timer;
};

}  // namespace hitscope
