// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shots/shot_script.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <random>

#include "session/session.h"

namespace hitscope {

namespace {

constexpr double kUnitStep = 1.0 / 4294967296.0;  // of a 32-bit number in [0, 1)
constexpr float kNoLength = 1.0e-6f;

/// In [-1, 1), the same on every machine (the standard's distributions are not).
double signedUnit(std::mt19937& random) {
    return 2.0 * static_cast<double>(random()) * kUnitStep - 1.0;
}

/// Two unit vectors that make a right angle with `axis` (unit) and each other.
struct Sides {
    glm::dvec3 right;
    glm::dvec3 up;
};

Sides sidesOf(const glm::dvec3& axis) {
    const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(axis, other));
    return {right, glm::cross(right, axis)};
}

/// Evenly over the cap around `axis`, whose rim is at the cosine `least`. Archimedes: the height along the
/// axis of an even spread over a sphere is even itself, and so is the squared radius over a disk.
glm::vec3 inCone(const glm::dvec3& axis, const Sides& sides, double least, std::mt19937& random) {
    double x = 0.0;
    double y = 0.0;
    double squared = 2.0;
    while (squared > 1.0 || squared == 0.0) {
        x = signedUnit(random);
        y = signedUnit(random);
        squared = x * x + y * y;
    }
    const double along = 1.0 - squared * (1.0 - least);
    const double aside = std::sqrt(std::max(0.0, 1.0 - along * along) / squared);
    return glm::vec3(axis * along + sides.right * (x * aside) + sides.up * (y * aside));
}

int usable(int count) {
    return std::clamp(count, 0, ShotScript::kMostShots);
}

}  // namespace

std::vector<TimedShot> burst(const Ray& axis, int count, float halfAngle, std::uint32_t seed,
                             double interval) {
    std::mt19937 random(seed);
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(axis.direction));
    const Sides sides = sidesOf(ahead);
    const double least = std::cos(static_cast<double>(std::clamp(halfAngle, 0.0f, glm::pi<float>())));
    std::vector<TimedShot> shots;
    for (int i = 0; i < usable(count); ++i) {
        shots.push_back({i * interval, {axis.origin, inCone(ahead, sides, least, random)}});
    }
    return shots;
}

std::vector<TimedShot> sweep(const Ray& from, const Ray& to, int count, double interval) {
    std::vector<TimedShot> shots;
    const int last = usable(count) - 1;
    for (int i = 0; i <= last; ++i) {
        const float part = last == 0 ? 0.0f : static_cast<float>(i) / static_cast<float>(last);
        const glm::vec3 direction = glm::mix(from.direction, to.direction, part);
        if (const float length = glm::length(direction); length > kNoLength) {
            shots.push_back({i * interval, {glm::mix(from.origin, to.origin, part), direction / length}});
        }
    }
    return shots;
}

std::vector<TimedShot> circle(const Ray& axis, const glm::vec3& up, float halfAngle, int count,
                              double interval) {
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(axis.direction));
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(up)));
    const glm::dvec3 top = glm::cross(right, ahead);
    const double along = std::cos(static_cast<double>(halfAngle));
    const double aside = std::sin(static_cast<double>(halfAngle));
    std::vector<TimedShot> shots;
    for (int i = 0; i < usable(count); ++i) {
        const double turn = glm::two_pi<double>() * i / count;
        const glm::dvec3 direction = ahead * along + (top * std::cos(turn) + right * std::sin(turn)) * aside;
        shots.push_back({i * interval, {axis.origin, glm::vec3(glm::normalize(direction))}});
    }
    return shots;
}

void schedule(Session& session, const ShotScript& script) {
    std::vector<ScheduledShot> shots;
    shots.reserve(script.shots.size());
    for (const TimedShot& shot : script.shots) {
        shots.push_back({shot.time, shot.ray, script.projectile, script.isInstant});
    }
    session.simulation().schedule(shots);
}

}  // namespace hitscope
