// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QMouseEvent;

namespace hitscope {

class Viewport;

/// Drags the line between original and deformed with the mouse; Escape or the right button takes the drag
/// back. Sees the viewport's events before it does.
class WipeHandle : public QObject {
    Q_OBJECT
public:
    /// `viewport` owns this.
    explicit WipeHandle(Viewport& viewport);

    static constexpr int kGrip = 5;  ///< logical pixels to either side of the line

Q_SIGNALS:
    void dragged(float wipeAt);  ///< of the picture's width, [0, 1]

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool isAt(const QMouseEvent& event) const;
    [[nodiscard]] double pictureWidth() const;  ///< one of two, side by side
    [[nodiscard]] double leftOfPicture(const QMouseEvent& event) const;
    [[nodiscard]] bool isCancelledBy(const QEvent& event) const;

    Viewport& m_viewport;
    bool m_held = false;
    double m_heldLeft = 0.0;    ///< of the picture whose line is held
    float m_heldBefore = 0.0f;  ///< where the line was, of the picture's width
};

}  // namespace hitscope
