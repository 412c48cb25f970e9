// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/motion_sweep.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "physics/bullet_conversions.h"

namespace hitscope::physics {
namespace {

/// What comes from below passes it, as a line does.
std::optional<double> castAtFloor(double floor, double from, double motion, double radius) {
    const double height = from - floor - radius;
    if (from < floor || motion >= 0.0 || height + motion > 0.0) {
        return std::nullopt;
    }
    return std::max(0.0, height / -motion);
}

/// Around all that the sphere sweeps; a little more, since it is rounded to float.
Bounds boxAround(const glm::vec3& from, const glm::vec3& motion, float radius) {
    Bounds box;
    box.add(from);
    box.add(from + motion);
    const glm::vec3 largest = glm::max(glm::abs(box.min), glm::abs(box.max));
    const float slack = radius + 1.0e-6f * (largest.x + largest.y + largest.z);
    return {box.min - slack, box.max + slack};
}

bool overlap(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

}  // namespace

bool isKind(const btCollisionObject& body, BodyKind kind) {
    return body.getUserIndex() == static_cast<int>(kind);
}

glm::dvec3 SweepScene::Entry::directionToLocal(const glm::dvec3& world) const {
    return rows[0] * world.x + rows[1] * world.y + rows[2] * world.z;
}

void SweepScene::clear() {
    m_entries.clear();
    m_floor.reset();
}

void SweepScene::addTarget(TargetId target, const btTransform& where, const CollisionShape& shape) {
    btVector3 low;
    btVector3 high;
    shape.bullet()->getAabb(where, low, high);
    Entry entry{target, &shape, {fromBullet(low), fromBullet(high)}, {}, {}, glm::dvec3(shape.centre())};
    for (int i = 0; i < 3; ++i) {
        entry.rows[i] = glm::dvec3(fromBullet(where.getBasis().getRow(i)));
    }
    entry.origin = glm::dvec3(fromBullet(where.getOrigin()));
    m_entries.push_back(entry);
}

std::optional<SweepContact> SweepScene::sweep(const glm::vec3& from, const glm::vec3& motion,
                                              float radius) const {
    if (!(glm::length(motion) > 0.0f)) {
        return std::nullopt;
    }
    const Bounds swept = boxAround(from, motion, radius);
    std::optional<SweepContact> first;
    const double r = static_cast<double>(radius);
    if (m_floor) {
        const auto floor =
            castAtFloor(*m_floor, static_cast<double>(from.y), static_cast<double>(motion.y), r);
        if (floor) {
            first = SweepContact{{}, *floor, -1};
        }
    }
    for (const Entry& entry : m_entries) {
        if (!overlap(entry.box, swept)) {
            continue;
        }
        const glm::dvec3 start = entry.directionToLocal(glm::dvec3(from) - entry.origin) + entry.centre;
        const auto met = entry.shape->cast(start, entry.directionToLocal(glm::dvec3(motion)), r);
        if (met && (!first || met->fraction < first->fraction)) {
            first = SweepContact{entry.target, met->fraction, met->triangle};
        }
    }
    return first;
}

}  // namespace hitscope::physics
