// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/cutting_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/section_view.h"

namespace hitscope {

namespace {

constexpr float kPlaneMargin = 1.12f;  // of the box's size
constexpr float kLeastSide = 1.0e-6f;  // metres

}  // namespace

glm::vec4 CuttingPlane::kept() const {
    return flipped ? glm::vec4(normal, -offset) : glm::vec4(-normal, offset);
}

bool CuttingPlane::hides(const glm::vec3& point) const {
    return on && glm::dot(kept(), glm::vec4(point, 1.0f)) < 0.0f;
}

std::optional<ShownRay> shownPart(const CuttingPlane& plane, const Ray& ray, float length) {
    if (!plane.on) {
        return ShownRay{ray, length};
    }
    const float within = glm::dot(plane.kept(), glm::vec4(ray.origin, 1.0f));
    const float deeper = glm::dot(glm::vec3(plane.kept()), ray.direction);  // a metre on
    if (within >= 0.0f) {
        return ShownRay{ray, deeper < 0.0f ? std::min(length, within / -deeper) : length};
    }
    if (deeper <= 0.0f || -within / deeper >= length) {
        return std::nullopt;
    }
    const float enters = -within / deeper;
    return ShownRay{{ray.origin + enters * ray.direction, ray.direction}, length - enters};
}

OffsetRange offsetRange(const Bounds& bounds, const glm::vec3& normal) {
    const float middle = glm::dot(normal, bounds.centre());
    const float reach = glm::dot(glm::abs(normal), 0.5f * bounds.size());
    return {middle - reach, middle + reach};
}

PlaneFrame planeFrame(const CuttingPlane& plane, const Bounds& bounds) {
    const SectionView view = sectionView(plane.openSide());
    const auto half = [&bounds](const SectionView::Axis& axis) {
        const float reach = glm::dot(glm::abs(axis.direction), 0.5f * bounds.size());
        const float side = std::max(kPlaneMargin * reach, kLeastSide);
        return (axis.mirrored ? -side : side) * axis.direction;
    };
    const float off = plane.offset - glm::dot(plane.normal, bounds.centre());
    return {bounds.centre() + off * plane.normal, half(view.right), half(view.up)};
}

}  // namespace hitscope
