// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/hit.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>
#include <string>
#include <string_view>

#include "core/finite.h"

namespace hitscope {
namespace {

/// Numbers so small that deforming with them could give denormal ones, which some renderers flush to zero,
/// count as 0 from the start.
float withoutTiny(float value, float smallest) {
    return std::abs(value) < smallest ? 0.0f : value;
}

void removeTiny(Hit& hit) {
    constexpr float kSmallestComponent = 1e-20f;
    for (glm::length_t i = 0; i < 3; ++i) {
        hit.direction[i] = withoutTiny(hit.direction[i], kSmallestComponent);
    }
    hit.constants = withoutTiny(hit.constants);
}

Error notFinite(const char* field) {
    return {"A number of the hit is infinite or not a number.", field,
            "Give a finite number, or leave this hit out."};
}

Error outOfRange(const ParameterDescriptor& parameter, double value) {
    std::ostringstream what;
    what << parameter.label << " is " << value << ", which is not between " << parameter.minimum << " and "
         << parameter.maximum;
    if (!parameter.unit.empty()) {
        what << " " << parameter.unit;
    }
    what << ".";
    return {what.str(), std::string(parameter.key), "Choose a value in this range."};
}

}  // namespace

DeformationConstants withoutTiny(const DeformationConstants& constants) {
    constexpr float kSmallestConstant = 1e-15f;  // square metres, metres
    return {constants.maxDistance, withoutTiny(constants.power, kSmallestConstant),
            withoutTiny(constants.maxMagnitude, kSmallestConstant)};
}

Result<Hit> checkedHit(Hit hit) {
    if (!isFinite(hit.point)) {
        return notFinite("hit point");
    }
    if (!isFinite(hit.direction)) {
        return notFinite("hit direction");
    }
    if (!isFinite(hit.normal)) {
        return notFinite("hit normal");
    }
    if (!std::isfinite(hit.time) || !std::isfinite(hit.speed) || !std::isfinite(hit.impulse)) {
        return notFinite("hit time, speed or impulse");
    }
    for (std::size_t i = 0; i < hitParameters().size(); ++i) {
        const double value = parameterValue(hit.constants, i);
        if (!hitParameters()[i].accepts(value)) {
            return outOfRange(hitParameters()[i], value);
        }
    }
    if (const std::string_view fault = faultOf(hit.form); !fault.empty()) {
        return Error{std::string(fault), "hit form", "Choose another form, or leave this hit out."};
    }
    hit.form = plain(hit.form);
    // In double no float can overflow or vanish here.
    const glm::dvec3 direction(hit.direction);
    const double lengthSquared = glm::dot(direction, direction);
    if (lengthSquared == 0.0) {
        return Error{"The hit has no direction: all three numbers are zero.", "hit direction",
                     "Give the direction the projectile flew in."};
    }
    // A direction that is unit to float's precision keeps its bits: a hit read back from a session must
    // deform exactly as it did when it was made.
    if (std::abs(lengthSquared - 1.0) > 2.5e-7) {
        hit.direction = glm::vec3(direction / std::sqrt(lengthSquared));
    }
    if (!hit.group) {
        hit.group = {};
    }
    removeTiny(hit);
    return hit;
}

}  // namespace hitscope
