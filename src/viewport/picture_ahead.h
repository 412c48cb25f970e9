// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <cstdint>
#include <functional>

namespace hitscope {

/// Has pictures of a widget drawn before its window paints itself, so that events need not wait until a
/// renderer on the CPU has finished them: a turn of the event loop hands the drawing over to the renderer's
/// threads, others see to events, and one in which the picture is finished paints the window. Until then the
/// window paints nothing: composing it would wait for the picture.
///
/// Qt asks a window to paint itself by an event (QEvent::UpdateRequest), which is held back for that. Where a
/// window paints itself all the same, since it has another size, the last picture is shown again.
class PictureAhead : public QObject {
    Q_OBJECT
public:
    struct Hooks {
        std::function<bool()> begin;       ///< hands over the drawing; false: the widget draws by itself
        std::function<bool()> isFinished;  ///< of what was handed over last
    };
    /// `widget` outlives this.
    PictureAhead(QWidget& widget, Hooks hooks);

    /// Off: the widget draws by itself.
    void setOn(bool on);
    /// A picture of what is there now is wanted; another one that is being drawn comes before it.
    void want();
    /// What the widget shows now, asked while it paints itself.
    enum class Shown : std::uint8_t {
        Ahead,  ///< the picture drawn ahead
        Last,   ///< the one that was shown last, or is under way; one of what there is now follows
        Itself  ///< it draws by itself, which includes what was wanted
    };
    /// byWindow: its window paints itself. hasLast: there is a picture that was drawn ahead.
    [[nodiscard]] Shown take(bool byWindow, bool hasLast);
    /// Whether one has been handed over that is not shown yet.
    [[nodiscard]] bool isUnderWay() const { return m_state == State::Drawing; }
    /// What is under way shows nothing that is still wanted.
    void drop();
    /// A picture was shown: the next one may come.
    void shown();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class State : std::uint8_t { Nothing, Drawing, Showing };

    void look();
    void askToPaint();

    QWidget& m_widget;
    Hooks m_hooks;
    QPointer<QWidget> m_window;
    QTimer m_timer;  ///< to look() while one is under way
    State m_state = State::Nothing;
    bool m_isOn = false;
    bool m_isWanted = false;
    bool m_isUnable = false;  ///< to draw the one that is painted now
};

}  // namespace hitscope
