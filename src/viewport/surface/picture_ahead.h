// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>

namespace hitscope {

/// Has pictures drawn between events, which need not wait until a renderer on the CPU has finished them: a
/// turn of the event loop hands the drawing over to the renderer's threads, others see to events, and one in
/// which the picture is finished shows it.
class PictureAhead : public QObject {
    Q_OBJECT
public:
    struct Hooks {
        /// Does a part of what comes before a picture, between events as well; false: another part is left.
        std::function<bool()> prepare;
        std::function<bool()> begin;       ///< hands over the drawing; false: nothing can be drawn ahead now
        std::function<bool()> isFinished;  ///< of what was handed over last
        /// Shows it, and shown() follows; false: nothing shows it now, as its widget is hidden.
        std::function<bool()> show;
        std::function<void()> paint;  ///< has the widget draw and show a picture itself, in its own time
    };
    explicit PictureAhead(Hooks hooks);

    /// Off, as it is at first: the widget draws by itself.
    void setOn(bool on);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    /// A picture of what is there now is wanted, once this event is over; another one that is being drawn
    /// comes before it.
    void want();
    /// Whether one has been handed over that is not shown yet.
    [[nodiscard]] bool isUnderWay() const { return m_state == State::Drawing; }
    /// What is under way shows nothing that is still wanted.
    void drop();
    /// The widget draws by itself what is there now. Returns whether that was wanted.
    bool drawn();
    /// A picture was shown: the next one may come.
    void shown();

private:
    enum class State : std::uint8_t { Nothing, Drawing, Showing };

    void goOn();
    /// What fits into a turn; false: a part is left.
    [[nodiscard]] bool prepare();

    Hooks m_hooks;
    QTimer m_timer;  ///< to begin one, or to look whether what is under way is finished
    State m_state = State::Nothing;
    bool m_isOn = false;
    bool m_isWanted = false;
    bool m_isDue = false;  ///< a call of goOn() comes, right after the event that wanted it
};

}  // namespace hitscope
