// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace hitscope {

/// Which of the keys W A S D E Q are held down.
class FlyKeys {
public:
    /// False when `key` (a Qt::Key) is none of them.
    bool press(int key);
    bool release(int key);
    void clear() { m_held = 0; }
    [[nodiscard]] bool any() const { return m_held != 0; }
    /// Right, up, forward; each -1, 0 or 1: what is held cancels out.
    [[nodiscard]] glm::vec3 direction() const;

private:
    unsigned m_held = 0;  ///< a bit a key
};

}  // namespace hitscope
