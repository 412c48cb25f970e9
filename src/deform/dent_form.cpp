// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/dent_form.h"

#include <algorithm>
#include <cmath>

namespace hitscope {

namespace {

constexpr float kSmallestOrdinate = 1e-6f;

/// Where two neighbouring differences have one sign, their harmonic mean; else level.
float slopeBetween(float before, float after) {
    const bool isMonotone = (before > 0.0f && after > 0.0f) || (before < 0.0f && after < 0.0f);
    return isMonotone ? (2.0f * (before * after)) / (before + after) : 0.0f;
}

/// At an end: of the parabola through three points, held to what keeps the cubic monotone.
float slopeAtEnd(float nearest, float next) {
    const float slope = (3.0f * nearest - next) * 0.5f;
    const bool isSameSign = (slope > 0.0f && nearest > 0.0f) || (slope < 0.0f && nearest < 0.0f);
    if (!isSameSign) {
        return 0.0f;
    }
    return std::abs(slope) > 3.0f * std::abs(nearest) ? 3.0f * nearest : slope;
}

}  // namespace

DentForm plain(const DentForm& form) {
    DentForm own = form;
    if (own.presses()) {
        own.profile = DentProfile::Paper;
    } else {
        own.radius = 0.0f;
    }
    if (own.profile != DentProfile::Curve) {
        own.curve = kUsualCurve;
    }
    for (float& ordinate : own.curve) {
        ordinate = std::abs(ordinate) < kSmallestOrdinate ? 0.0f : ordinate;
    }
    return own;
}

std::string_view faultOf(const DentForm& form) {
    if (static_cast<std::size_t>(form.profile) >= kDentProfileKeys.size() ||
        static_cast<std::size_t>(form.direction) >= kDentDirectionKeys.size()) {
        return "The form of the dent is unknown.";
    }
    const bool isCurve = form.profile == DentProfile::Curve && !form.presses();
    const auto isShare = [](float ordinate) { return ordinate >= -1.0f && ordinate <= 1.0f; };
    if (isCurve && !std::all_of(form.curve.begin(), form.curve.end(), isShare)) {
        return "A point of the fall-off curve is not between -1 and 1.";
    }
    if (form.presses() && !(form.radius >= kLeastPressRadius && form.radius <= kMostPressRadius)) {
        return "The hit presses, and the radius of its projectile is not known.";
    }
    return {};
}

CurveTerms termsOf(const CurveOrdinates& ordinates) {
    constexpr std::size_t kLast = kCurvePoints - 1;
    std::array<float, kLast> steps{};
    for (std::size_t i = 0; i < kLast; ++i) {
        steps[i] = ordinates[i + 1] - ordinates[i];
    }
    CurveTerms terms{};
    for (std::size_t i = 0; i < kCurvePoints; ++i) {
        terms[2 * i] = ordinates[i];
        terms[2 * i + 1] = i == 0       ? slopeAtEnd(steps[0], steps[1])
                           : i == kLast ? slopeAtEnd(steps[kLast - 1], steps[kLast - 2])
                                        : slopeBetween(steps[i - 1], steps[i]);
    }
    return terms;
}

}  // namespace hitscope
