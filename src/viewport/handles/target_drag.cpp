// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handles/target_drag.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "session/shown_number.h"
#include "view/change_options.h"
#include "viewport/handles/handle_geometry.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kRoundSteps = 4;                          // at most, in the reach
constexpr double kRoundTurn = std::numbers::pi / 12.0;  // radians
constexpr double kFineTurn = std::numbers::pi / 1800.0;
constexpr float kFarthest = 1.0e3f;  // times the distance of the eye, where a line runs to the horizon

struct TargetDragTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::TargetDrag)
};

double roundedToStep(double value, double step) {
    return step * std::round(value / step);
}

/// The step of a number that a pixel more or less does not tell apart.
double fineStep(double pixel) {
    return std::pow(10.0, std::floor(std::log10(pixel)));
}

}  // namespace

glm::vec3 axisOf(std::size_t axis) {
    glm::vec3 unit(0.0f);
    unit[static_cast<int>(axis)] = 1.0f;
    return unit;
}

glm::vec3 onCircle(std::size_t axis, double angle) {
    return static_cast<float>(std::cos(angle)) * axisOf((axis + 1) % kAxes) +
           static_cast<float>(std::sin(angle)) * axisOf((axis + 2) % kAxes);
}

QChar letterOf(std::size_t axis) {
    return QChar(static_cast<char16_t>(u'X' + axis));
}

TargetDrag::TargetDrag(Viewport& viewport, std::vector<TargetPlace> before, const glm::vec3& middle,
                       QPointF from, Kind kind)
    : m_viewport(viewport), m_before(std::move(before)), m_middle(middle), m_from(from), m_kind(kind) {}

bool TargetDrag::moves(TargetId id) const {
    return std::any_of(m_before.begin(), m_before.end(),
                       [id](const TargetPlace& place) { return place.id == id; });
}

std::vector<TargetPlace> TargetDrag::places() const {
    std::vector<TargetPlace> places = m_before;
    if (m_shift == glm::vec3(0.0f) && m_turned == 0.0) {
        return places;
    }
    const glm::quat turn = m_kind.turns ? glm::angleAxis(static_cast<float>(m_turned), axisOf(m_kind.axis))
                                        : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
    for (TargetPlace& place : places) {
        RigidTransform& transform = place.transform;
        transform.position = m_middle + turn * (transform.position - m_middle) + m_shift;
        transform.rotation = turn * transform.rotation;
    }
    return places;
}

void TargetDrag::takeBack() {
    m_shift = glm::vec3(0.0f);
    m_turned = 0.0;
}

void TargetDrag::dragTo(const QPointF& to, bool rounds) {
    if (!m_kind.turns) {
        const glm::vec3 shift = shiftTo(to, rounds);
        m_shift = std::isfinite(shift.x + shift.y + shift.z) ? shift : m_shift;
        return;
    }
    // By the nearest of the angles that look the same: a drag may go round several times.
    const double more = std::remainder(angleTo(to) - angleTo(m_from) - m_angle, 2.0 * std::numbers::pi);
    m_angle += std::isfinite(more) ? more : 0.0;
    m_turned = roundedToStep(m_angle, rounds ? kRoundTurn : kFineTurn);
}

/// The place nearest to it on the axis as the picture shows it, which the drag began on.
QPointF TargetDrag::onLine(const QPointF& to) const {
    const glm::vec3 end = m_middle + kHandleReach * pixelAt(m_viewport, m_middle) * axisOf(m_kind.axis);
    const QPointF line = placeInPicture(m_viewport, end).value_or(m_from) -
                         placeInPicture(m_viewport, m_middle).value_or(m_from);
    const double squared = QPointF::dotProduct(line, line);
    return squared > 0.0 ? m_from + QPointF::dotProduct(to - m_from, line) / squared * line : to;
}

/// World, metres, from where the drag began.
glm::vec3 TargetDrag::shiftTo(const QPointF& to, bool rounds) const {
    const Navigation& navigation = m_viewport.navigation();
    const double pixel = static_cast<double>(pixelAt(m_viewport, m_middle));
    const double reach = static_cast<double>(kHandleReach) * pixel;
    const double step = rounds ? niceStep(0.0, reach, kRoundSteps) : fineStep(pixel);
    const auto rounded = [step](float way) {
        return static_cast<float>(roundedToStep(static_cast<double>(way), step));
    };
    if (m_kind.axis < kAxes) {
        const glm::vec3 axis = axisOf(m_kind.axis);
        const float farthest = kFarthest * glm::distance(m_middle, m_viewport.camera().eye());
        const float way = nearestAlong(navigation.rayInFirst(onLine(to)), m_middle, axis) -
                          nearestAlong(navigation.rayInFirst(m_from), m_middle, axis);
        return rounded(std::clamp(way, -farthest, farthest)) * axis;
    }
    const glm::vec3 forward = m_viewport.camera().forward();
    const auto inPlane = [&](const QPointF& place) {
        const Ray ray = navigation.rayInFirst(place);
        const float way = glm::dot(m_middle - ray.origin, forward) / glm::dot(ray.direction, forward);
        return ray.origin + way * ray.direction;
    };
    const glm::vec3 way = inPlane(to) - inPlane(m_from);
    return {rounded(way.x), rounded(way.y), rounded(way.z)};
}

/// Radians about the dragged axis, but for a constant.
double TargetDrag::angleTo(const QPointF& to) const {
    const glm::vec3 axis = axisOf(m_kind.axis);
    const Ray ray = m_viewport.navigation().rayInFirst(to);
    const float way = glm::dot(m_middle - ray.origin, axis) / glm::dot(ray.direction, axis);
    if (!(way > 0.0f)) {
        return std::numeric_limits<double>::quiet_NaN();  // beyond the plane's horizon
    }
    const glm::vec3 at = ray.origin + way * ray.direction - m_middle;
    return std::atan2(static_cast<double>(glm::dot(at, axisOf((m_kind.axis + 2) % kAxes))),
                      static_cast<double>(glm::dot(at, axisOf((m_kind.axis + 1) % kAxes))));
}

QString TargetDrag::text() const {
    const auto signedText = [](double value) {
        const QString digits = shownNumber(std::abs(value), 'g', 4);
        return (value < 0.0 ? QStringLiteral("\u2212") : QStringLiteral("+")) + digits;
    };
    if (m_kind.turns) {
        const double degrees = std::round(m_turned * 1800.0 / std::numbers::pi) / 10.0;
        return TargetDragTexts::tr("%1 %2°").arg(letterOf(m_kind.axis)).arg(signedText(degrees));
    }
    QStringList parts;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (m_kind.axis == axis || m_kind.axis == kAxes) {
            const auto way = static_cast<double>(m_shift[static_cast<int>(axis)]);
            parts.append(TargetDragTexts::tr("%1 %2 m").arg(letterOf(axis)).arg(signedText(way)));
        }
    }
    return parts.join(QStringLiteral("  "));
}

}  // namespace hitscope
