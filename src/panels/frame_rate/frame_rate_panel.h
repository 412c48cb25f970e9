// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "core/frame_times.h"

class QAction;

namespace Ui {
class FrameRate;
}

namespace hitscope {

/// The dock "Frame rate": read-outs and a scrolling graph of the frames drawn.
class FrameRatePanel : public QWidget {
    Q_OBJECT
public:
    /// `continuous` is offered as a button; it outlives the panel.
    explicit FrameRatePanel(QAction& continuous, QWidget* parent = nullptr);
    ~FrameRatePanel() override;

    void addFrame(double seconds);  ///< a frame ended just now and took that long
    void clear();
    [[nodiscard]] FrameTimes::Summary summary() const;

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makePlot();
    void applyPalette();
    void refresh();
    void plotSamples();
    void showReadOuts();
    [[nodiscard]] double now() const;  ///< seconds since the panel was made

    std::unique_ptr<Ui::FrameRate> m_ui;
    FrameTimes m_frames;
    QElapsedTimer m_clock;
    QTimer m_timer;
    double m_lastRefresh = -1.0;  ///< of the graph; below 0: it has yet to be drawn
};

}  // namespace hitscope
