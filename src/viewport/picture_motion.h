// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "viewport/motion_scale.h"

namespace hitscope {

/// Whether a picture moves, and so may be drawn smaller than it is shown; says when it has come to rest and
/// is wanted in full size.
class PictureMotion : public QObject {
    Q_OBJECT
public:
    explicit PictureMotion(QObject* parent = nullptr);

    /// Off: every picture has its full size.
    void setOn(bool on) { m_isOn = on; }
    /// The picture changes now, and likely once more soon.
    void moved();
    /// Part of its width and height that the picture which is drawn now has.
    [[nodiscard]] float beginFrame();
    /// What was drawn last has been shown, so many seconds after it was begun.
    void frameShown(double seconds);
    /// Part of its width and height that the last picture had.
    [[nodiscard]] float lastScale() const { return m_scale; }
    [[nodiscard]] bool isReduced() const { return m_scale < 1.0f; }
    /// Frames take another time from now on.
    void forget() { m_motion.forget(); }
    /// Draws what moves at this scale, whatever the time that frames take; nothing: as their time demands.
    void hold(std::optional<float> scale) { m_held = scale; }

    static constexpr int kRest = 60;  ///< milliseconds from the last frame in motion to one of full size

Q_SIGNALS:
    void rested();  ///< the last picture was smaller than it is shown; nothing has moved since

private:
    void rest();

    MotionScale m_motion;
    std::optional<float> m_held;
    bool m_isOn = false;
    bool m_isFirst = true;     ///< the next frame is a motion's first
    bool m_isCounted = false;  ///< the last one was not
    float m_scale = 1.0f;      ///< of the last picture
    QTimer m_timer;            ///< runs while the picture moves
};

}  // namespace hitscope
