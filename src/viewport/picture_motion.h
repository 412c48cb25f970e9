// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "viewport/motion_detail.h"

namespace hitscope {

/// Whether a picture moves, and so may be drawn with less detail; says when it has come to rest and is wanted
/// in full.
///
/// Where a picture in full takes very long and the refiner draws one in parts anyway, a still picture is
/// drawn with fewer triangles too: nobody waits for the first, and the refiner's takes its place.
class PictureMotion : public QObject {
    Q_OBJECT
public:
    explicit PictureMotion(QObject* parent = nullptr);

    /// Off: every picture is drawn in full.
    void setOn(bool on);
    /// Whether a refiner draws still pictures in full.
    void setRefined(bool on);
    /// Other threads are at work: drawing takes longer than it did, and every picture in full is left to the
    /// refiner.
    void setBusy(bool on);
    /// As MotionDetail::setLongestFrame().
    void setLongestFrame(double seconds) { m_motion.setLongestFrame(seconds); }
    /// As MotionDetail::setCoarsePart(). isSlow: a picture in full is expected to take too long, so that the
    /// first is left to the refiner as well.
    void setCoarsePart(float part, bool isSlow = false);
    /// A picture in full that takes longer, or keeps events waiting for longer while it is drawn, is left to
    /// the refiner once two did in a row, or one took half as long again; seconds.
    void setSlow(double seconds, double waiting) {
        m_slow = seconds;
        m_slowWaiting = waiting;
    }
    /// The session catches up, and events wait for pictures: those that are left to the refiner have half of
    /// the pixels, too.
    void setCatchingUp(bool on) { m_isCatchingUp = on; }
    /// The picture changes now, and likely once more soon.
    void moved();
    /// Whether it did a moment ago.
    [[nodiscard]] bool isMoving() const { return m_timer.isActive(); }
    /// Of the next picture, as things are.
    [[nodiscard]] PictureDetail coming() const;
    /// Of the picture that is drawn now.
    [[nodiscard]] PictureDetail beginFrame();
    /// What was drawn last has been shown, so many seconds after it was begun.
    void frameShown(double seconds);
    /// The last picture was the refiner's, or the one before, drawn again in part. isRough: there with fewer
    /// triangles.
    void keptShown(bool isRough);
    /// Of the last picture.
    [[nodiscard]] const PictureDetail& lastDetail() const { return m_detail; }
    /// Of what was drawn last: from close by there may be all triangles all the same. `waiting`: for so many
    /// seconds events had to wait meanwhile.
    void drawn(bool coarse, double waiting) {
        m_drewCoarse = coarse;
        m_waiting = waiting;
    }
    /// The picture that is shown, as one sees it.
    [[nodiscard]] const PictureDetail& seenDetail() const { return m_seen; }
    /// Whether another picture comes, in full, once nothing moves.
    [[nodiscard]] bool isReduced() const;
    /// Frames take another time from now on.
    void forget();
    /// The next frames are seen from that far away, metres.
    void seenFrom(float distance);
    /// Draws what moves with this detail, whatever the time that frames take; nothing: as their time demands.
    void hold(std::optional<PictureDetail> detail) { m_held = detail; }

    static constexpr int kRest = 60;  ///< milliseconds from the last frame in motion to one in full

Q_SIGNALS:
    void rested();  ///< the last picture was not in full; nothing has moved since

private:
    void rest();
    void drawInFullIfAtRest();
    void judgeFull(double seconds);
    [[nodiscard]] bool isFirstComing() const;  ///< the next picture is a motion's first, or none moves
    [[nodiscard]] bool isHurried() const { return m_isCatchingUp && isLeftToRefiner() && !m_held; }
    [[nodiscard]] bool isLeftToRefiner() const {
        return m_isOn && m_isRefined && (m_isSlow || (m_isBusy && m_motion.hasCoarse()));
    }

    MotionDetail m_motion;
    std::optional<PictureDetail> m_held;
    bool m_isOn = false;
    bool m_isRefined = false;
    bool m_isBusy = false;
    bool m_isKeptShown = false;
    bool m_isCatchingUp = false;
    double m_slow = 0.1;
    double m_slowWaiting = 0.045;
    double m_waiting = 0.0;
    bool m_isSlowFirst = false;  ///< one is expected to take too long
    bool m_isSlow = false;       ///< one took too long, or is expected to
    int m_fullFrames = 0;        ///< drawn since frames took another time
    int m_slowFrames = 0;        ///< the last ones of these
    bool m_isFirst = true;       ///< the next frame is a motion's first
    bool m_isCounted = false;    ///< the last one was not
    bool m_isDrawn = false;      ///< the last one, but not shown yet
    bool m_isRestDue = false;    ///< once it is
    bool m_drewCoarse = false;   ///< the last one did
    PictureDetail m_detail;      ///< of the last picture
    PictureDetail m_seen;        ///< of the last one that was shown
    float m_distance = 0.0f;     ///< metres, where what is no help was forgotten last
    QTimer m_timer;              ///< runs while the picture moves
};

}  // namespace hitscope
