// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/stand_targets.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <vector>

#include "session/session.h"

namespace hitscope {

namespace {

/// World, of the vertices that faces use, as they are dented. In double precision: a scan may stand far from
/// the origin.
struct Extent {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};

    void add(const Target& target, const RigidTransform& transform) {
        const glm::dmat3 turn = glm::mat3_cast(glm::dquat(transform.rotation));
        const glm::dvec3 origin(transform.position);
        const std::span<const DynamicVertex> vertices = target.deformed.vertices();
        for (const DynamicVertex& vertex : vertices.first(target.shape.render->drawnVertices)) {
            const glm::dvec3 at = origin + turn * glm::dvec3(vertex.position);
            min = glm::min(min, at);
            max = glm::max(max, at);
        }
    }
    [[nodiscard]] bool isEmpty() const { return !(min.y <= max.y); }
};

std::vector<const Target*> targetsOf(const Session& session, std::span<const TargetId> ids) {
    std::vector<const Target*> targets;
    for (const TargetId id : ids) {
        if (const Target* target = session.targets().find(id)) {
            targets.push_back(target);
        }
    }
    return targets;
}

}  // namespace

Status turnUpright(Session& session, std::span<const TargetId> ids) {
    const std::vector<const Target*> targets = targetsOf(session, ids);
    Extent before;
    for (const Target* target : targets) {
        before.add(*target, target->transform);
    }
    if (before.isEmpty()) {
        return Done{};
    }
    const float root = glm::one_over_root_two<float>();  // cosine and sine of half the angle
    const glm::quat quarter(root, -root, 0.0f, 0.0f);
    const glm::vec3 middle(0.5 * (before.min + before.max));
    std::vector<TargetPlace> places;
    Extent after;
    for (const Target* target : targets) {
        const RigidTransform& now = target->transform;
        const RigidTransform turned{middle + quarter * (now.position - middle),
                                    glm::normalize(quarter * now.rotation)};
        after.add(*target, turned);
        places.push_back({target->id, turned});
    }
    for (TargetPlace& place : places) {
        place.transform.position.y += static_cast<float>(before.min.y - after.min.y);
    }
    return session.targets().setTransforms(places);
}

Status setOnFloor(Session& session, std::span<const TargetId> ids) {
    const auto floor = static_cast<double>(session.targets().floorHeight());
    std::vector<TargetPlace> places;
    for (const Target* target : targetsOf(session, ids)) {
        Extent extent;
        extent.add(*target, target->transform);
        if (!extent.isEmpty()) {
            RigidTransform lowered = target->transform;
            lowered.position.y += static_cast<float>(floor - extent.min.y);
            places.push_back({target->id, lowered});
        }
    }
    return session.targets().setTransforms(places);
}

}  // namespace hitscope
