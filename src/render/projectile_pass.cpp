// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/projectile_pass.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace hitscope::render {
namespace {

constexpr int kSegments = 24;
constexpr int kRings = 16;
constexpr GLuint kPosition = 0;
constexpr GLuint kInstance = 5;
static_assert(sizeof(Sphere) == 4 * sizeof(float) && offsetof(Sphere, radius) == 3 * sizeof(float),
              "spheres go to the GPU as they are: centre, radius");

std::vector<glm::vec3> sphereVertices() {
    std::vector<glm::vec3> vertices;
    for (int ring = 0; ring <= kRings; ++ring) {
        const float theta = glm::pi<float>() * static_cast<float>(ring) / kRings;
        for (int segment = 0; segment <= kSegments; ++segment) {
            const float phi = glm::two_pi<float>() * static_cast<float>(segment) / kSegments;
            vertices.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                  std::sin(theta) * std::sin(phi));
        }
    }
    return vertices;
}

std::vector<std::uint16_t> sphereIndices() {
    std::vector<std::uint16_t> indices;
    const auto add = [&indices](int ring, int segment) {
        indices.push_back(static_cast<std::uint16_t>(ring * (kSegments + 1) + segment));
    };
    for (int ring = 0; ring < kRings; ++ring) {
        for (int segment = 0; segment < kSegments; ++segment) {
            add(ring, segment);
            add(ring, segment + 1);
            add(ring + 1, segment);
            add(ring + 1, segment);
            add(ring, segment + 1);
            add(ring + 1, segment + 1);
        }
    }
    return indices;
}

}  // namespace

ProjectilePass::ProjectilePass()
    : m_vertices(gl::Buffer::make()),
      m_indices(gl::Buffer::make()),
      m_instances(gl::Buffer::make()),
      m_array(gl::VertexArray::make()) {
    const auto vertices = sphereVertices();
    const auto indices = sphereIndices();
    m_indexCount = static_cast<GLsizei>(indices.size());
    glBindVertexArray(m_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_vertices.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec3)),
                 vertices.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(kPosition);
    glVertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, m_instances.id());
    glEnableVertexAttribArray(kInstance);
    glVertexAttribPointer(kInstance, 4, GL_FLOAT, GL_FALSE, sizeof(Sphere), nullptr);
    glVertexAttribDivisor(kInstance, 1);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint16_t)),
                 indices.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

Status ProjectilePass::draw(const FrameContext& context) {
    const std::span<const Sphere> spheres = context.frame.projectiles;
    if (spheres.empty()) {
        return Done{};
    }
    const auto found =
        context.programs.get("projectile.vert", "surface.frag", lightDefines(context.frame.lights));
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    setLights(program, context);
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_eye", context.eye);
    program.set("u_diffuse", glm::vec3(0.78f, 0.30f, 0.07f));
    program.set("u_specular", glm::vec3(0.6f));
    program.set("u_shininess", 48.0f);
    glBindVertexArray(m_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_instances.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(spheres.size_bytes()), spheres.data(),
                 GL_STREAM_DRAW);
    glDrawElementsInstanced(GL_TRIANGLES, m_indexCount, GL_UNSIGNED_SHORT, nullptr,
                            static_cast<GLsizei>(spheres.size()));
    return Done{};
}

}  // namespace hitscope::render
