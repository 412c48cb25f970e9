// SPDX-License-Identifier: GPL-3.0-or-later
// The hits that the brush makes.
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "deform/scattered_hits.h"
#include "session/session.h"
#include "session/usual_dent.h"
#include "viewport/brush_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr double kFewestAStep = 1e-9;  // metres: no spacing is less

}  // namespace

/// As the brush makes hits on that target now, but for where and which way. A hit that presses has the radius
/// of the projectiles that clicks send.
Hit BrushTool::modelOn(TargetId target) const {
    const Target* on = m_session.targets().find(target);
    const SessionSettings& settings = m_session.settings();
    Hit hit;
    hit.target = target;
    hit.constants = on != nullptr ? settings.constantsOn(*on) : settings.constants();
    hit.form = usualForm(m_session, hit);
    resize(hit, m_settings.size);
    for (const std::size_t strong : {kPower, kMaxMagnitude}) {
        const double value = parameterValue(hit.constants, strong) * m_settings.strength;
        setParameterValue(hit.constants, strong, std::min(value, hitParameters()[strong].maximum));
    }
    return hit;
}

/// Metres: how far from its place a hit reaches.
float BrushTool::radiusOf(const Hit& hit) {
    return hit.form.presses() ? hit.form.radius : hit.constants.maxDistance;
}

/// Against the mesh's own normals: those of dented triangles would turn from hit to hit.
glm::vec3 BrushTool::inwardAt(const Hit& hit) const {
    const Target* target = m_session.targets().find(hit.target);
    if (target == nullptr || hit.triangle >= target->deformed.render().triangles.size() / 3) {
        return -hit.normal;
    }
    const RenderMesh& mesh = target->deformed.render();
    const std::uint32_t* corners = &mesh.triangles[std::size_t{3} * hit.triangle];
    const auto at = [&](int corner) { return target->deformed.vertices()[corners[corner]].position; };
    // Each corner's part is the area across from it.
    glm::vec3 normal(0.0f);
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 a = at((i + 1) % 3) - hit.point;
        const glm::vec3 b = at((i + 2) % 3) - hit.point;
        normal += glm::length(glm::cross(a, b)) * mesh.vertices[corners[i]].normal;
    }
    constexpr float kTooShort = 1e-20f;
    if (!(glm::dot(normal, normal) > kTooShort)) {
        return -hit.normal;
    }
    normal = glm::normalize(normal);
    return glm::dot(normal, hit.normal) < 0.0f ? normal : -normal;
}

/// As the brush would make it there; nothing beside targets. All that has been painted is on the colliders.
std::optional<Hit> BrushTool::hitAt(const QPointF& position) const {
    const Ray ray = m_viewport.navigation().rayAt(position);
    const auto shown = shownPart(m_viewport.options().cut, ray, std::numeric_limits<float>::max());
    if (!shown) {
        return std::nullopt;
    }
    std::optional<Hit> hit = m_session.simulation().predictedHit(shown->ray, true);
    const Target* target = hit ? m_session.targets().find(hit->target) : nullptr;
    if (target == nullptr ||
        glm::distance(target->transform.toWorld(hit->point), shown->ray.origin) > shown->length) {
        return std::nullopt;
    }
    if (m_settings.isInward && hit->normal != glm::vec3(0.0f)) {
        hit->direction = inwardAt(*hit);
    }
    const Hit model = modelOn(hit->target);
    hit->constants = model.constants;
    hit->form = model.form;
    hit->speed = 0.0f;  // no projectile flew
    hit->impulse = 0.0f;
    return hit;
}

std::optional<glm::vec3> BrushTool::surfaceAt(const QPointF& position) const {
    const auto met = m_viewport.aiming().met(m_viewport.navigation().rayAt(position));
    return met && met->target ? std::optional(met->point) : std::nullopt;
}

double BrushTool::spacingOf(const Hit& hit) const {
    const double spacing = m_settings.spacingMetres > 0.0
                               ? m_settings.spacingMetres
                               : m_settings.spacing * static_cast<double>(radiusOf(hit));
    return std::max(spacing, kFewestAStep);
}

}  // namespace hitscope
