// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "viewport/catch_up.h"

class QWidget;

namespace hitscope {

class Navigation;
class PictureFlow;
class PictureSurface;
class Session;
class ViewportScene;

/// When a viewport draws frames, and what goes on between them. Draws only when something changed; while
/// projectiles fly, the camera moves or continuous drawing is on, each frame moves the session on by the time
/// the last one took and asks for the next.
class FrameLoop : public QObject {
    Q_OBJECT
public:
    struct Parts {
        Session& session;
        ViewportScene& scene;
        PictureSurface& surface;
        PictureFlow& pictures;
        Navigation& navigation;
    };
    /// All of them outlive it.
    FrameLoop(Parts parts, const QWidget& viewport);

    /// A frame after the other even if nothing moves, as many as there can be: for measuring.
    void setContinuous(bool on) { m_continuous = on; }
    [[nodiscard]] bool isContinuous() const { return m_continuous; }
    /// Whether a frame comes right after this one.
    [[nodiscard]] bool followsOn() const;
    /// What is seen has changed: a picture comes, with the next ones where many hits are being applied.
    void followPicture();
    /// The window has painted itself: on with the next frame, if one follows.
    void windowPainted();

private:
    void followRefresh();
    void moveOn();      ///< after a frame or a slice: advances what moves by the time since the last
    void startClock();  ///< what begins to move now has moved by the time the next frame is there
    [[nodiscard]] bool isCatchingUp() const;
    /// Whether hits are being applied between pictures, where the CPU draws.
    [[nodiscard]] bool isApplying() const;
    [[nodiscard]] bool isFarBehind() const;
    void slice();
    void collectCosts();  ///< of the last frames, once no more follow
    void tryNext();

    Parts m_parts;
    const QWidget& m_viewport;
    bool m_continuous = false;
    bool m_unlimited = false;  ///< frames do not wait for the screen
    QElapsedTimer m_clock;     ///< since moveOn() last ran; invalid while nothing moves
    CatchUp m_catchUp;
    QTimer m_costsTimer;
    QTimer m_trialTimer;  ///< to tryNext(), while something has not been tried
};

}  // namespace hitscope
