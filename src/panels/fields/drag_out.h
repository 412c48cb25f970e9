// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPoint>
#include <functional>
#include <optional>

class QAbstractButton;
class QMimeData;

namespace hitscope {

/// Lets what a button writes be dragged out of the window instead: to a file manager, or into another
/// program. A click still does what it did.
class DragOut : public QObject {
    Q_OBJECT
public:
    /// make: called when a drag begins; null: there is nothing to drag. Belongs to the button.
    DragOut(QAbstractButton& button, std::function<QMimeData*()> make);
    [[nodiscard]] QMimeData* make() const { return m_make(); }  ///< what is dragged; the caller owns it

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void drag();

    QAbstractButton& m_button;
    std::function<QMimeData*()> m_make;
    std::optional<QPoint> m_pressedAt;
};

}  // namespace hitscope
