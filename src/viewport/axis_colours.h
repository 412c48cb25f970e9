// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <array>

namespace hitscope {

/// Of the world's axes where they are drawn over the picture: x, y, z.
inline QColor axisColour(std::size_t axis) {
    static const std::array<QColor, 3> colours{QColor(0xe2, 0x4d, 0x5c), QColor(0x5f, 0xa8, 0x32),
                                               QColor(0x3d, 0x83, 0xe0)};
    return colours[axis];
}

}  // namespace hitscope
