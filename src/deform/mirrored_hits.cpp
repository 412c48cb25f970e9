// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/mirrored_hits.h"

#include <glm/geometric.hpp>

namespace hitscope {

namespace {

/// The axis that the normal is along, by its index; -1: none.
int axisOf(const glm::vec3& normal) {
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[(axis + 1) % 3] == 0.0f && normal[(axis + 2) % 3] == 0.0f) {
            return axis;
        }
    }
    return -1;
}

/// What stands at right angles to the normal stays.
glm::vec3 mirroredDirection(glm::vec3 direction, const glm::vec3& normal) {
    if (const int axis = axisOf(normal); axis >= 0) {
        direction[axis] = -direction[axis];
        return direction;
    }
    const glm::dvec3 wide(direction);
    const glm::dvec3 across = glm::normalize(glm::dvec3(normal));
    return glm::vec3(wide - 2.0 * glm::dot(wide, across) * across);
}

glm::vec3 mirroredPoint(glm::vec3 point, const Plane& plane) {
    if (const int axis = axisOf(plane.normal); axis >= 0) {
        const float at = plane.normal[axis] < 0.0f ? -plane.offset : plane.offset;
        point[axis] = 2.0f * at - point[axis];
        return point;
    }
    const glm::dvec3 wide(point);
    const glm::dvec3 across = glm::normalize(glm::dvec3(plane.normal));
    return glm::vec3(wide - 2.0 * (glm::dot(wide, across) - static_cast<double>(plane.offset)) * across);
}

/// Nearer to itself than anybody could mean.
bool isOwnImage(const Hit& hit, const Hit& image) {
    constexpr float kSame = 1.0e-4f;  // of the reach; of a unit vector
    return glm::distance(hit.point, image.point) <= kSame * hit.constants.maxDistance &&
           glm::distance(hit.direction, image.direction) <= kSame;
}

}  // namespace

Hit mirrored(const Hit& hit, const Plane& plane) {
    Hit image = hit;
    image.point = mirroredPoint(hit.point, plane);
    image.direction = mirroredDirection(hit.direction, plane.normal);
    image.normal = mirroredDirection(hit.normal, plane.normal);
    image.flight = mirroredDirection(hit.flight, plane.normal);
    image.triangle = kNoIndex;
    image.group = {};
    return image;
}

std::vector<Hit> mirroredHits(std::span<const Hit> hits, const Plane& plane) {
    std::vector<Hit> images;
    images.reserve(hits.size());
    for (const Hit& hit : hits) {
        const Hit image = mirrored(hit, plane);
        if (!isOwnImage(hit, image)) {
            images.push_back(image);
        }
    }
    return images;
}

}  // namespace hitscope
