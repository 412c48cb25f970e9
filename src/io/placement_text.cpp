// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/placement_text.h"

#include <QLocale>
#include <cmath>

namespace hitscope {

QString placementText(const Placement& placement) {
    const auto number = [](double value) {
        const double size = std::abs(value);
        const bool isPlain = size == 0.0 || (size >= 1.0e-4 && size < 1.0e15);
        return QString::number(value, isPlain ? 'f' : 'g', QLocale::FloatingPointShortest);
    };
    const glm::dvec3 moved = glm::dvec3(0.0) - placement.centre;
    QString text = QStringLiteral("In the scene it is moved by (%1, %2, %3)")
                       .arg(number(moved.x), number(moved.y), number(moved.z));
    if (placement.scale != 1.0) {
        text += QStringLiteral(", then scaled by %1").arg(number(placement.scale));
    }
    return text + u'.';
}

}  // namespace hitscope
