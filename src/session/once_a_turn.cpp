// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/once_a_turn.h"

#include <utility>

namespace hitscope {

OnceATurn::OnceATurn(std::function<void()> act) : m_act(std::move(act)) {
    m_turn.setSingleShot(true);
    QObject::connect(&m_turn, &QTimer::timeout, &m_turn, [this] {
        if (m_isDue) {
            now();
        }
    });
}

void OnceATurn::want() {
    if (m_turn.isActive()) {
        m_isDue = true;
    } else {
        now();
    }
}

void OnceATurn::now() {
    m_isDue = false;
    m_turn.start(0);
    m_act();
}

}  // namespace hitscope
