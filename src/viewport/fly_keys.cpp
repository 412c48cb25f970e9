// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/fly_keys.h"

#include <QtCore/qnamespace.h>
#include <array>
#include <cstddef>

namespace hitscope {

namespace {

constexpr std::array<int, 6> kKeys{Qt::Key_W, Qt::Key_S, Qt::Key_A, Qt::Key_D, Qt::Key_E, Qt::Key_Q};

unsigned bitOf(int key) {
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        if (kKeys[i] == key) {
            return 1u << i;
        }
    }
    return 0;
}

}  // namespace

bool FlyKeys::press(int key) {
    m_held |= bitOf(key);
    return bitOf(key) != 0;
}

bool FlyKeys::release(int key) {
    m_held &= ~bitOf(key);
    return bitOf(key) != 0;
}

glm::vec3 FlyKeys::direction() const {
    const auto held = [this](int key) { return (m_held & bitOf(key)) != 0 ? 1.0f : 0.0f; };
    return {held(Qt::Key_D) - held(Qt::Key_A), held(Qt::Key_E) - held(Qt::Key_Q),
            held(Qt::Key_W) - held(Qt::Key_S)};
}

}  // namespace hitscope
