// SPDX-License-Identifier: GPL-3.0-or-later
// What a command shoots: a burst, random places of the surface, one place, or a script.
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <random>

#include "cli/shoot.h"
#include "cli/standard_streams.h"
#include "session/shots/shot_schedule.h"
#include "session/shots/shot_script_file.h"

namespace hitscope::cli {

namespace {

using Shots = ShootOptions::Shots;

constexpr float kFarthest = 1.0e7f;  // metres

/// In [0, 1), the same on every machine (the standard's distributions are not).
double unit(std::mt19937& random) {
    return static_cast<double>(random()) / 4294967296.0;
}

/// Places of visible targets' surfaces, each as likely as any other of its area.
class SurfacePlaces {
public:
    explicit SurfacePlaces(const Session& session) {
        for (const std::unique_ptr<Target>& target : session.targets()) {
            const std::size_t triangles = target->deformed.render().triangles.size() / 3;
            for (std::size_t i = 0; target->visible && i < triangles; ++i) {
                const std::array<glm::vec3, 3> corners = cornersOf(*target, i);
                const double area = 0.5 * static_cast<double>(glm::length(
                                              glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
                if (area > 0.0) {
                    m_sum += area;
                    m_triangles.push_back({target.get(), i, m_sum});
                }
            }
        }
    }
    [[nodiscard]] bool empty() const { return m_triangles.empty(); }

    struct Place {
        glm::vec3 point{0.0f};   ///< world
        glm::vec3 normal{0.0f};  ///< unit; the triangle's, whichever way it was wound
    };
    [[nodiscard]] Place next(std::mt19937& random) const {
        const double wanted = unit(random) * m_sum;
        const auto found =
            std::upper_bound(m_triangles.begin(), m_triangles.end() - 1, wanted,
                             [](double sum, const Triangle& triangle) { return sum < triangle.sum; });
        const std::array<glm::vec3, 3> corners = cornersOf(*found->target, found->number);
        auto a = static_cast<float>(unit(random));
        auto b = static_cast<float>(unit(random));
        if (a + b > 1.0f) {
            a = 1.0f - a;
            b = 1.0f - b;
        }
        const glm::vec3 u = corners[1] - corners[0];
        const glm::vec3 v = corners[2] - corners[0];
        return {corners[0] + a * u + b * v, glm::normalize(glm::cross(u, v))};
    }

private:
    struct Triangle {
        const Target* target;
        std::size_t number;
        double sum;  ///< of the areas up to it
    };
    static std::array<glm::vec3, 3> cornersOf(const Target& target, std::size_t triangle) {
        std::array<glm::vec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = target.deformed.render().triangles[3 * triangle + i];
            corners[i] = target.transform.toWorld(target.deformed.vertices()[vertex].position);
        }
        return corners;
    }

    std::vector<Triangle> m_triangles;
    double m_sum = 0.0;
};

/// Within 30 degrees of `normal`.
glm::vec3 aslant(const glm::vec3& normal, std::mt19937& random) {
    constexpr float kSpread = 0.5773503f;  // tan 30 degrees
    glm::vec3 aside(1.0f);
    while (glm::dot(aside, aside) > 1.0f) {
        for (int axis = 0; axis < 3; ++axis) {
            aside[axis] = static_cast<float>(2.0 * unit(random) - 1.0);
        }
    }
    return glm::normalize(normal + kSpread * (aside - glm::dot(aside, normal) * normal));
}

/// `away` metres from it and above `lowest` (world y): a shot that meets the surface where it is aimed at,
/// or, where none is found in some tries, one that meets a target at all; nothing: not even that.
std::optional<Ray> shotAtSurface(const Session& session, const SurfacePlaces& places, float away,
                                 float lowest, std::mt19937& random) {
    constexpr int kTries = 64;
    constexpr float kNear = 1.0e-3f;  // of `away`: the same place
    std::optional<Ray> second;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        const SurfacePlaces::Place place = places.next(random);
        for (const float side : {1.0f, -1.0f}) {
            const glm::vec3 from = aslant(side * place.normal, random);
            const Ray ray{place.point + away * from, -from};
            if (ray.origin.y < lowest) {
                continue;  // the floor would be in its way
            }
            const auto met = session.simulation().physics().castRay(ray.origin, ray.direction, 2.0f * away);
            if (met && session.targets().find(met->target) != nullptr) {
                if (glm::distance(met->point, place.point) <= kNear * away) {
                    return ray;
                }
                second = ray;  // it strikes something else first
            }
        }
    }
    return second;
}

/// Metres from which all of the scene is in front.
float awayFrom(const Session& session) {
    const Bounds bounds = session.targets().bounds();
    return bounds.empty() ? 1.0f : std::max(bounds.diagonal(), 1.0e-4f);
}

/// Where a shot through a point starts, with all of the scene in front.
glm::vec3 startOf(const Session& session, const ShootOptions& options, float away) {
    float behind = 0.0f;  // metres that the scene begins before the point
    const Bounds bounds = session.targets().bounds();
    for (int i = 0; i < 8 && !bounds.empty(); ++i) {
        const glm::vec3 corner((i & 1) != 0 ? bounds.max.x : bounds.min.x,
                               (i & 2) != 0 ? bounds.max.y : bounds.min.y,
                               (i & 4) != 0 ? bounds.max.z : bounds.min.z);
        behind = std::max(behind, glm::dot(options.at - corner, options.direction));
    }
    return options.at - std::max(2.0f * away, behind + away) * options.direction;
}

/// What of the projectile was given in words stays; else it flies as `flight` says.
ProjectileSettings projectileFor(const Session& session, const ShootOptions& options, FlightMode flight,
                                 const Target* target, float distance) {
    ProjectileSettings projectile =
        projectileOf(flight, session.settings().projectile(),
                     target != nullptr ? target->extent() : kUsualExtent, distance);
    for (std::size_t i = 0; i < options.projectile.size(); ++i) {
        if (options.projectile[i]) {
            setParameterValue(projectile, i, *options.projectile[i]);
        }
    }
    projectile.mostAlive = std::max(projectile.mostAlive, options.count);
    if (options.form.isAny()) {
        projectile.form = session.settings().constantsSetting().form;  // kept in a script, too
    }
    return projectile;
}

FlightMode flightFor(const ShootOptions& options) {
    const FlightMode usual = options.shots == Shots::At    ? FlightMode::Instant
                             : options.scenePath.isEmpty() ? FlightMode::Paper
                                                           : FlightMode::Quick;
    return options.flight.value_or(usual);
}

ShotScript newShots(const Session& session, const ShootOptions& options) {
    constexpr float kPicture = 16.0f / 9.0f;
    const bool isAt = options.shots == Shots::At;
    Camera camera;
    camera.frame(session.targets().bounds(), kPicture);
    const float away = awayFrom(session);
    const Ray axis =
        isAt ? Ray{startOf(session, options, away), options.direction} : Ray{camera.eye(), camera.forward()};
    const auto met = session.simulation().physics().castRay(axis.origin, axis.direction, kFarthest);
    const Target* target = met ? session.targets().find(met->target) : nullptr;
    if (target == nullptr && !session.targets().empty()) {
        target = session.targets().front().get();
    }
    const FlightMode flight = flightFor(options);
    const float distance = options.shots == Shots::Random ? away
                           : met                          ? glm::distance(met->point, axis.origin)
                                                          : camera.distance();
    ShotScript script;
    script.projectile = projectileFor(session, options, flight, target, distance);
    script.isInstant = flight == FlightMode::Instant;
    if (isAt) {
        script.shots = {{0.0, axis}};
    } else if (options.shots == Shots::Burst) {
        script.shots = burst(axis, options.count, static_cast<float>(glm::radians(options.cone)),
                             options.seed, options.interval);
    }
    return script;
}

Result<ShotScript> scriptFrom(const QString& path) {
    if (!isStandardStream(path)) {
        return readShotScript(path);
    }
    const Result<QByteArray> bytes = readAllOf(path, qint64{64} << 20);
    return bytes ? parseShotScript(bytes.value()) : Result<ShotScript>(bytes.error());
}

/// Metres from which random shots leave: all of the scene is in front, or, of what falls on its way, near.
float flightOf(const Session& session, const ShootOptions& options, const ShotScript& script) {
    constexpr float kNear = 4.0f;
    const bool falls =
        !script.isInstant && script.projectile.gravity > 0.0f && flightFor(options) != FlightMode::Quick;
    return falls ? std::min(awayFrom(session), kNear) : awayFrom(session);
}

/// One that strikes a target as the scene is now, whatever its projectile touches on the way; nothing: none
/// was found.
std::optional<Ray> strikingShot(Session& session, const SurfacePlaces& places, const ShotScript& script,
                                float away, std::mt19937& random) {
    constexpr int kTries = 32;
    session.simulation().updateColliders();  // without a time limit: all of them
    const float lowest = script.isInstant ? -std::numeric_limits<float>::infinity()
                                          : session.targets().floorHeight() + script.projectile.radius;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        const std::optional<Ray> ray = shotAtSurface(session, places, away, lowest, random);
        const ScheduledShot shot{0.0, ray.value_or(Ray{}), script.projectile, script.isInstant};
        if (ray && session.simulation().predictedHit(shot)) {
            return ray;
        }
    }
    return std::nullopt;
}

}  // namespace

Result<ShotScript> shotsOf(const Session& session, const ShootOptions& options) {
    switch (options.shots) {
        case Shots::None:
            return ShotScript{};
        case Shots::Script:
            return scriptFrom(options.scriptPath);
        case Shots::Burst:
        case Shots::Random:
        case Shots::At:
            break;
    }
    return newShots(session, options);
}

ShotScript shootAtSurface(Session& session, const ShootOptions& options,
                          const std::function<void(const ShotScript& shot)>& play) {
    // Hits may push all of the surface below the floor, where no shot gets to.
    constexpr int kMostFailures = 64;  // in a row, each of thousands of places
    std::mt19937 random(options.seed);
    const SurfacePlaces places(session);
    const auto count = static_cast<std::size_t>(options.count);
    ShotScript script = newShots(session, options);
    const float away = flightOf(session, options, script);
    const double start = session.simulation().physics().clock().time();
    int failures = places.empty() ? kMostFailures : 0;
    while (script.shots.size() < count && failures < kMostFailures) {
        const std::optional<Ray> ray = strikingShot(session, places, script, away, random);
        if (!ray) {
            ++failures;
            continue;
        }
        failures = 0;
        const double wait = script.shots.empty() ? 0.0 : options.interval;
        ShotScript shot{script.projectile, script.isInstant, {{wait, *ray}}};
        const double now = session.simulation().physics().clock().time();
        script.shots.push_back({now + shot.shots.front().time - start, *ray});
        play(shot);
    }
    return script;
}

}  // namespace hitscope::cli
