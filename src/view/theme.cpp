// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/theme.h"

#include <cmath>

#include "core/srgb.h"

namespace hitscope {
namespace {

const ThemeColours kDark{
    .backgroundTop = {0.225f, 0.24f, 0.265f},
    .backgroundBottom = {0.12f, 0.125f, 0.14f},
    .floor = {0.05f, 0.053f, 0.06f},
    .floorLines = {0.62f, 0.66f, 0.72f, 0.32f},
    .contactShade = 0.5f,
    .wire = {0.04f, 0.05f, 0.07f, 0.6f},
    .wireOnly = {0.80f, 0.85f, 0.92f, 0.85f},
    .needles = {0.45f, 0.80f, 1.0f, 0.9f},
    .dots = {0.96f, 0.97f, 1.0f, 0.95f},
    .cutFill = {0.47f, 0.50f, 0.55f},
    .accent = {1.0f, 0.62f, 0.2f},
};

const ThemeColours kLight{
    .backgroundTop = {0.93f, 0.94f, 0.955f},
    .backgroundBottom = {0.86f, 0.872f, 0.892f},
    .floor = {0.86f, 0.87f, 0.89f},
    .floorLines = {0.30f, 0.33f, 0.38f, 0.34f},
    .contactShade = 0.38f,
    .wire = {0.08f, 0.10f, 0.14f, 0.55f},
    .wireOnly = {0.14f, 0.18f, 0.25f, 0.8f},
    .needles = {0.05f, 0.35f, 0.75f, 0.9f},
    .dots = {0.05f, 0.07f, 0.12f, 0.9f},
    .cutFill = {0.74f, 0.76f, 0.79f},
    .accent = {0.85f, 0.36f, 0.0f},
};

}  // namespace

const ThemeColours& themeColours(Theme theme) {
    return theme == Theme::Light ? kLight : kDark;
}

glm::vec3 toLinear(const glm::vec3& srgb) {
    return {linearOfSrgb(srgb.r), linearOfSrgb(srgb.g), linearOfSrgb(srgb.b)};
}

}  // namespace hitscope
