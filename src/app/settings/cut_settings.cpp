// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/cut_settings.h"

#include <QSettings>
#include <QStringList>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace hitscope {

namespace {

constexpr float kUnit = 1.0e-3f;  // how far from 1 a normal's length may be

const QString kNormal = QStringLiteral("cut/normal");

constexpr std::array<std::pair<const char*, bool CuttingPlane::*>, 4> kSwitches{
    {{"cut/flipped", &CuttingPlane::flipped},
     {"cut/originalLine", &CuttingPlane::originalLine},
     {"cut/deformedLine", &CuttingPlane::deformedLine},
     {"cut/fill", &CuttingPlane::fill}}};

}  // namespace

void loadCutSettings(const QSettings& settings, CuttingPlane& cut) {
    const QStringList parts = settings.value(kNormal).toStringList();
    if (parts.size() == 3) {
        const glm::vec3 normal(parts[0].toFloat(), parts[1].toFloat(), parts[2].toFloat());
        if (std::abs(glm::length(normal) - 1.0f) < kUnit) {
            cut.normal = glm::normalize(normal);
        }
    }
    for (const auto& [key, option] : kSwitches) {
        cut.*option = settings.value(QLatin1String(key), cut.*option).toBool();
    }
}

void saveCutSettings(QSettings& settings, const CuttingPlane& cut) {
    const auto number = [](float part) { return QString::number(static_cast<double>(part), 'g', 9); };
    settings.setValue(kNormal, QStringList{number(cut.normal.x), number(cut.normal.y), number(cut.normal.z)});
    for (const auto& [key, option] : kSwitches) {
        settings.setValue(QLatin1String(key), cut.*option);
    }
}

}  // namespace hitscope
