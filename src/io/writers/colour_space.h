// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cmath>

namespace hitscope {

/// glTF has vertex colours as light, all other formats as they are shown (sRGB); a mesh has them as its file.
inline bool hasLinearColours(const QString& sourcePath) {
    return sourcePath.endsWith(QStringLiteral(".gltf"), Qt::CaseInsensitive) ||
           sourcePath.endsWith(QStringLiteral(".glb"), Qt::CaseInsensitive);
}

/// IEC 61966-2-1, of [0, 1].
inline float linearOf(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}
inline float srgbOf(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

}  // namespace hitscope
