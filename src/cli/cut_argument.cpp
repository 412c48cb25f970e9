// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cut_argument.h"

#include <QStringList>
#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope::cli {

namespace {

constexpr float kLeastNormal = 1.0e-6f;

std::optional<float> number(const QString& text) {
    bool isNumber = false;
    const float value = text.toFloat(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<glm::vec3> direction(const QString& text) {
    const QString axes = QStringLiteral("xyz");
    glm::vec3 made(0.0f);
    if (text.size() == 1 && axes.contains(text)) {
        made[static_cast<int>(axes.indexOf(text))] = 1.0f;
        return made;
    }
    const QStringList parts = text.split(u',');
    for (int i = 0; i < 3; ++i) {
        const std::optional<float> part = number(parts.value(i));
        if (parts.size() != 3 || !part) {
            return std::nullopt;
        }
        made[i] = *part;
    }
    const float length = glm::length(made);
    return std::isfinite(length) && length > kLeastNormal ? std::optional(made / length) : std::nullopt;
}

}  // namespace

std::optional<CuttingPlane> parseCut(const QString& text) {
    const QStringList sides = text.split(u'=');
    CuttingPlane cut;
    cut.on = true;
    QString across = sides.constFirst();
    if (across.size() == 2 && across.startsWith(u'-')) {
        cut.flipped = true;
        across.remove(0, 1);
    }
    const std::optional<glm::vec3> normal = direction(across);
    const std::optional<float> offset = number(sides.value(1));
    if (sides.size() != 2 || !normal || !offset) {
        return std::nullopt;
    }
    cut.normal = *normal;
    cut.offset = *offset;
    return cut;
}

}  // namespace hitscope::cli
