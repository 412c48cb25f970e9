// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/light_rows.h"

#include <algorithm>
#include <cmath>

#include "core/srgb.h"

namespace hitscope {

namespace {

PointLight& point(Lights& lights, int row) {
    return lights.points[static_cast<std::size_t>(row - FirstPointRow)];
}

}  // namespace

bool& lightOn(Lights& lights, int row) {
    return row == DirectionalRow ? lights.directional.on
           : row == SpotRow      ? lights.spot.on
                                 : point(lights, row).on;
}

LightTerms& lightTerms(Lights& lights, int row) {
    return row == DirectionalRow ? lights.directional.terms
           : row == SpotRow      ? lights.spot.terms
                                 : point(lights, row).terms;
}

Attenuation* lightAttenuation(Lights& lights, int row) {
    return row == DirectionalRow ? nullptr
           : row == SpotRow      ? &lights.spot.attenuation
                                 : &point(lights, row).attenuation;
}

glm::vec3* lightPosition(Lights& lights, int row) {
    return row == DirectionalRow ? nullptr
           : row == SpotRow      ? &lights.spot.position
                                 : &point(lights, row).position;
}

glm::vec3* lightDirection(Lights& lights, int row) {
    return row == DirectionalRow ? &lights.directional.direction
           : row == SpotRow      ? &lights.spot.direction
                                 : nullptr;
}

QString colourName(const glm::vec3& linear) {
    const auto part = [](float value) {
        const long level = std::lround(255.0f * std::clamp(srgbOfLinear(value), 0.0f, 1.0f));
        return QStringLiteral("%1").arg(level, 2, 16, QLatin1Char('0'));
    };
    return u'#' + part(linear.r) + part(linear.g) + part(linear.b);
}

glm::vec3 linearColour(float red, float green, float blue) {
    return {linearOfSrgb(red), linearOfSrgb(green), linearOfSrgb(blue)};
}

}  // namespace hitscope
