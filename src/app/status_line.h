// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/frame_times.h"
#include "session/session.h"
#include "view/picture_detail.h"

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace hitscope {

/// What the status bar says: on the right pipeline, renderer, target, vertices, hits, frame rate; on the left
/// what takes a while at the moment (Session::tasks()), with a button to cancel it.
class StatusLine : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this; the labels belong to `bar`.
    StatusLine(const Session& session, QStatusBar& bar, QObject* parent = nullptr);

    void setRenderer(const QString& name);
    /// detail: as in frameRateText()
    void setFrameRate(const FrameTimes::Summary& summary, const PictureDetail& detail = {});

private:
    QLabel* addCell(const QString& toolTip);
    void makeProgress();
    void showTask();
    void makeRoom();
    void layOut();
    void showScene();
    void showTarget();
    void showHits();
    void showPipeline();
    void showRenderer();

    const Session& m_session;
    QStatusBar& m_bar;
    QLabel* m_pipeline = nullptr;
    QLabel* m_renderer = nullptr;
    QLabel* m_target = nullptr;
    QLabel* m_vertices = nullptr;
    QLabel* m_hits = nullptr;
    QLabel* m_frameRate = nullptr;
    QWidget* m_progress = nullptr;
    QLabel* m_doing = nullptr;
    QProgressBar* m_fraction = nullptr;
    QString m_rendererName;
    QToolButton* m_cancel = nullptr;
    QTimer m_progressDelay;
    QTimer m_taskChanged;      ///< to showTask(), after what is going on
    QElapsedTimer m_taskTime;  ///< since it is shown
    int m_task = 0;            ///< the one that is shown; 0: none
};

}  // namespace hitscope
