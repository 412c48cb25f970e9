// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <functional>

namespace hitscope {

/// Does something that many signals ask for, one for each of thousands of targets, say: for the first of them
/// at once, for all others together in the next turn of the event loop.
class OnceATurn {
public:
    /// What `act` needs outlives this.
    explicit OnceATurn(std::function<void()> act);

    void want();
    /// Whatever was done in this turn; nothing is due then.
    void now();
    /// It was wanted again since it was done.
    [[nodiscard]] bool isDue() const { return m_isDue; }

private:
    std::function<void()> m_act;
    QTimer m_turn;  ///< active: it was done in this one
    bool m_isDue = false;
};

}  // namespace hitscope
