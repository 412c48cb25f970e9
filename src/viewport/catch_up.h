// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace hitscope {

/// Paces a viewport whose session catches up, where the CPU draws: what is to be done is done in slices,
/// between which events are seen to, and a picture comes after the first one, then twice a second. A picture
/// after each slice would take longer than all slices.
class CatchUp : public QObject {
    Q_OBJECT
public:
    static constexpr qint64 kBetweenPictures = 500;  ///< milliseconds

    explicit CatchUp(QObject* parent = nullptr);

    /// Another slice comes, in a turn of the event loop without a picture.
    void sliceLater() { m_timer.start(); }
    [[nodiscard]] bool isSliceComing() const { return m_timer.isActive(); }
    /// A slice was done, or something else has changed.
    void wantPicture() { m_isPictureWanted = true; }
    /// A picture was shown, of all slices before it.
    void pictureShown();
    /// Nothing is left to be done.
    void end() { m_hasPicture = false; }
    /// Whether something has changed since the last picture.
    [[nodiscard]] bool isPictureWanted() const { return m_isPictureWanted; }
    /// isMoving: so does what is seen besides.
    [[nodiscard]] bool isPictureDue(bool isMoving) const;

Q_SIGNALS:
    void sliceDue();

private:
    void beginSlice();

    QTimer m_timer;  ///< to the next slice
    QElapsedTimer m_sincePicture;
    bool m_isPictureWanted = false;
    bool m_hasPicture = false;      ///< since it began
    bool m_isAfterPicture = false;  ///< perhaps in the same turn
};

}  // namespace hitscope
