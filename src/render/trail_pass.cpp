// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/trail_pass.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "render/projectile_mesh.h"

namespace hitscope::render {
namespace {

constexpr GLuint kTrailPosition = 0;
constexpr GLuint kColour = 1;
constexpr float kOpacity = 0.55f;   // next to the projectile
constexpr float kHalfWidth = 0.6f;  // of the radius, next to the projectile
constexpr float kStill = 0.25f;     // of the radius: a shorter part of a trail is none

std::uint32_t packed(const glm::vec3& colour, float opacity) {
    const auto byte = [](float part) { return static_cast<std::uint32_t>(std::lround(part * 255.0f)); };
    return byte(colour.r) | byte(colour.g) << 8 | byte(colour.b) << 16 | byte(opacity) << 24;
}

struct Edge {
    TrailVertex left;
    TrailVertex right;
};

}  // namespace

void addTrail(const ProjectileItem& projectile, const Camera& camera, std::vector<TrailVertex>& vertices) {
    const glm::vec3 eye = camera.eye();
    const std::span<const glm::vec3> trail = projectile.trail;
    const auto parts = static_cast<float>(trail.size());
    std::optional<Edge> last;
    glm::vec3 from = projectile.sphere.centre;
    // Straight away from the projectile, so that the ribbon's first edge is known.
    for (std::size_t i = trail.size(); i-- > 0;) {
        const glm::vec3 to = trail[i];
        const glm::vec3 along = to - from;
        const glm::vec3 across = glm::cross(along, camera.isOrthographic() ? -camera.forward() : eye - to);
        const float length = glm::length(across);
        if (glm::dot(along, along) < kStill * kStill * projectile.sphere.radius * projectile.sphere.radius ||
            !(length > 0.0f)) {
            continue;
        }
        const auto edge = [&](const glm::vec3& at, float age) {
            const float left = 1.0f - age;
            const float width = kHalfWidth * drawnRadius(camera, at, projectile.sphere.radius);
            const glm::vec3 aside = across * (width * left / length);
            const std::uint32_t colour = packed(projectile.colour, kOpacity * left * left);
            return Edge{{at - aside, colour}, {at + aside, colour}};
        };
        const float age = static_cast<float>(trail.size() - i) / parts;
        const Edge begin = last ? *last : edge(from, 0.0f);
        const Edge end = edge(to, age);
        if (!last) {
            vertices.insert(vertices.end(), {begin.left, begin.left, begin.right});
        }
        vertices.insert(vertices.end(), {end.left, end.right});
        last = end;
        from = to;
    }
    if (last) {
        vertices.push_back(last->right);
    }
}

TrailPass::TrailPass() : m_buffer(gl::Buffer::make()), m_array(gl::VertexArray::make()) {
    glBindVertexArray(m_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.id());
    glEnableVertexAttribArray(kTrailPosition);
    glVertexAttribPointer(kTrailPosition, 3, GL_FLOAT, GL_FALSE, sizeof(TrailVertex), nullptr);
    glEnableVertexAttribArray(kColour);
    glVertexAttribPointer(kColour, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(TrailVertex),
                          reinterpret_cast<const void*>(offsetof(TrailVertex, colour)));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

Status TrailPass::draw(const FrameContext& context) {
    m_vertices.clear();
    for (const ProjectileItem& projectile : context.frame.projectiles) {
        addTrail(projectile, context.frame.camera, m_vertices);
    }
    if (m_vertices.empty()) {
        return Done{};
    }
    const auto found = context.programs.get("trail.vert", "trail.frag");
    if (!found) {
        return found.error();
    }
    found.value()->use();
    found.value()->set("u_viewProjection", context.viewProjection);
    glBindVertexArray(m_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(m_vertices.size() * sizeof(TrailVertex)),
                 m_vertices.data(), GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(m_vertices.size()));
    return Done{};
}

}  // namespace hitscope::render
