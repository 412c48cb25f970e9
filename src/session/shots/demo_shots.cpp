// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shots/demo_shots.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

namespace hitscope {

namespace {

constexpr float kFlight = 4.0f;  // metres from the muzzle to the surface
constexpr float kLowestNormal =
    -0.2f;                             // world y of the normal; below it the shot would come out of the floor
constexpr float kSpread = 0.5773503f;  // tan 30 degrees
constexpr int kTriesPerShot = 64;

/// In [-1, 1), the same on every machine (the standard's distributions are not).
float signedUnit(std::mt19937& random) {
    return static_cast<float>(random()) * (2.0f / 4294967296.0f) - 1.0f;
}

std::optional<Ray> shotAt(const Target& target, std::mt19937& random) {
    const RenderMesh& mesh = target.deformed.render();
    const auto vertices = std::span(mesh.vertices).first(mesh.drawnVertices);
    if (vertices.empty()) {
        return std::nullopt;
    }
    for (int attempt = 0; attempt < kTriesPerShot; ++attempt) {
        const DynamicVertex& vertex = vertices[random() % vertices.size()];
        const glm::vec3 normal = target.transform.directionToWorld(vertex.normal);
        const glm::vec3 aside{signedUnit(random), signedUnit(random), signedUnit(random)};
        const glm::vec3 towards = normal + kSpread * aside * 0.57735f;
        if (normal.y < kLowestNormal || !(glm::dot(towards, normal) > 0.0f)) {
            continue;
        }
        const glm::vec3 aim = target.transform.toWorld(vertex.position);
        const glm::vec3 from = glm::normalize(towards);
        return Ray{aim + kFlight * from, -from};
    }
    return std::nullopt;
}

}  // namespace

std::vector<Ray> demoShots(const Session& session, int count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Ray> shots;
    std::vector<const Target*> targets;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (target->visible) {
            targets.push_back(target.get());
        }
    }
    for (int i = 0; i < count && !targets.empty(); ++i) {
        const Target& target = *targets[static_cast<std::size_t>(i) % targets.size()];
        if (const std::optional<Ray> shot = shotAt(target, random)) {
            shots.push_back(*shot);
        }
    }
    return shots;
}

void shootAll(Session& session, const std::vector<Ray>& shots) {
    constexpr double kBetween = 0.1;  // seconds
    constexpr double kLanding = 1.0;  // seconds, for the last one
    for (const Ray& shot : shots) {
        session.simulation().shoot(shot);
        session.simulation().advance(kBetween);
    }
    for (double waited = 0.0; waited < kLanding; waited += kBetween) {
        session.simulation().advance(kBetween);
    }
}

}  // namespace hitscope
