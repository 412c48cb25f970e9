// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "physics/physics_world.h"
#include "session/shots/shot_schedule.h"
#include "view/camera.h"

namespace hitscope {

class Navigation;
class Session;
struct CuttingPlane;

/// What a line of sight meets, and what is shot along it. What the cutting plane hides is not in the way.
class Aiming {
public:
    /// All outlive this.
    Aiming(Session& session, const Navigation& navigation, const CuttingPlane& cut)
        : m_session(session), m_navigation(navigation), m_cut(cut) {}

    /// The shown surface it meets first, of a target or of the floor.
    [[nodiscard]] std::optional<PhysicsWorld::RayHit> met(const Ray& ray) const;
    /// What a click shoots along a line of sight: by the session's flight mode, and by what is there.
    [[nodiscard]] ScheduledShot shotAt(const Ray& sight) const;
    /// Its parts, for who shoots several of a kind: the projectile, and the ray, raised so that such a
    /// projectile lands where the line of sight does.
    [[nodiscard]] ProjectileSettings projectileFor(const Ray& sight) const;
    [[nodiscard]] Ray launched(const Ray& sight, const ProjectileSettings& projectile) const;

private:
    struct Aim {
        Ray from;                     ///< where what is shot starts, and the line of sight from there
        std::optional<glm::vec3> to;  ///< where it ends; nothing: nowhere
        float extent = 0.0f;          ///< metres, of the target there, or of the largest
        float distance = 0.0f;        ///< metres, to there, or a fair guess
    };
    [[nodiscard]] Aim aim(const Ray& sight) const;

    Session& m_session;
    const Navigation& m_navigation;
    const CuttingPlane& m_cut;
};

}  // namespace hitscope
