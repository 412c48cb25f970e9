// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/projectile_pass.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <tuple>
#include <vector>

#include "render/projectile_mesh.h"

namespace hitscope::render {
namespace {

constexpr GLuint kProjectilePosition = 0;
constexpr GLuint kInstance = 5;
static_assert(sizeof(Sphere) == 4 * sizeof(float) && offsetof(Sphere, radius) == 3 * sizeof(float),
              "spheres go to the GPU as they are: centre, radius");

/// The finest first: how finely a sphere is drawn, and from which radius in pixels on. The outline of the one
/// before, a polygon of 5 * frequency corners or more, leaves the circle by 0.4 pixels there.
struct Fineness {
    int frequency;
    float pixels;
};
constexpr Fineness kFineness[ProjectilePass::kLevels] = {{8, 33.0f}, {4, 8.0f}, {2, 3.0f}, {1, 0.0f}};

std::size_t levelOf(const Sphere& sphere, const FrameContext& context) {
    const float distance = glm::distance(sphere.centre, context.eye);
    const float pixels = sphere.radius * context.pixelsAt(std::max(distance, sphere.radius));
    std::size_t level = 0;
    while (pixels < kFineness[level].pixels) {
        ++level;
    }
    return level;
}

/// What one draw call has in common.
struct Batch {
    std::size_t level = 0;
    glm::vec3 colour{0.0f};

    [[nodiscard]] auto key() const { return std::tuple(level, colour.r, colour.g, colour.b); }
};

}  // namespace

ProjectilePass::ProjectilePass() : m_instances(gl::Buffer::make()) {
    for (std::size_t i = 0; i < kLevels; ++i) {
        const BallMesh ball = makeBall(kFineness[i].frequency);
        Level& level = m_levels[i];
        level.vertices = gl::Buffer::make();
        level.indices = gl::Buffer::make();
        level.array = gl::VertexArray::make();
        level.indexCount = static_cast<GLsizei>(ball.indices.size());
        glBindVertexArray(level.array.id());
        glBindBuffer(GL_ARRAY_BUFFER, level.vertices.id());
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ball.vertices.size() * sizeof(glm::vec3)),
                     ball.vertices.data(), GL_STATIC_DRAW);
        glEnableVertexAttribArray(kProjectilePosition);
        glVertexAttribPointer(kProjectilePosition, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
        glEnableVertexAttribArray(kInstance);
        glVertexAttribDivisor(kInstance, 1);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, level.indices.id());
        glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(ball.indices.size() * sizeof(std::uint16_t)),
                     ball.indices.data(), GL_STATIC_DRAW);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

Status ProjectilePass::draw(const FrameContext& context) {
    const std::span<const ProjectileItem> items = context.frame.projectiles;
    if (items.empty()) {
        return Done{};
    }
    gl::Defines defines = lightDefines(context.frame.lights);
    addSight(defines, context.frame);
    const auto found = context.programs.get("projectile.vert", "surface.frag", defines);
    if (!found) {
        return found.error();
    }
    const gl::Program& program = *found.value();
    program.use();
    setLights(program, context);
    program.set("u_viewProjection", context.viewProjection);
    program.set("u_eye", context.eye);
    setSight(program, context.frame);
    program.set("u_specular", glm::vec3(0.6f));
    program.set("u_shininess", 48.0f);

    std::vector<std::pair<Batch, Sphere>> sorted;
    sorted.reserve(items.size());
    for (const ProjectileItem& item : items) {
        const Sphere drawn{item.sphere.centre,
                           drawnRadius(context.frame.camera, item.sphere.centre, item.sphere.radius)};
        if (drawn.radius > 0.0f) {
            sorted.push_back({{levelOf(drawn, context), item.colour}, drawn});
        }
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.first.key() < b.first.key(); });
    std::vector<Sphere> spheres;
    spheres.reserve(sorted.size());
    for (const auto& entry : sorted) {
        spheres.push_back(entry.second);
    }
    glBindBuffer(GL_ARRAY_BUFFER, m_instances.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(spheres.size() * sizeof(Sphere)), spheres.data(),
                 GL_STREAM_DRAW);
    for (std::size_t begin = 0; begin < sorted.size();) {
        const Batch& batch = sorted[begin].first;
        std::size_t end = begin + 1;
        while (end < sorted.size() && sorted[end].first.key() == batch.key()) {
            ++end;
        }
        const Level& level = m_levels[batch.level];
        program.set("u_diffuse", toLinear(batch.colour));
        glBindVertexArray(level.array.id());
        glVertexAttribPointer(kInstance, 4, GL_FLOAT, GL_FALSE, sizeof(Sphere),
                              reinterpret_cast<const void*>(begin * sizeof(Sphere)));
        glDrawElementsInstanced(GL_TRIANGLES, level.indexCount, GL_UNSIGNED_SHORT, nullptr,
                                static_cast<GLsizei>(end - begin));
        begin = end;
    }
    return Done{};
}

}  // namespace hitscope::render
