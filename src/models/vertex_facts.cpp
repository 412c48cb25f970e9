// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_facts.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "models/quantity_text.h"

namespace hitscope {

double angleBetween(const glm::vec3& a, const glm::vec3& b) {
    const glm::dvec3 from(a);
    const glm::dvec3 to(b);
    return std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
}

VertexFacts vertexFacts(const DeformedMesh& mesh, std::uint32_t vertex) {
    VertexFacts facts;
    facts.original = mesh.original().positions[vertex];
    facts.current = mesh.positions()[vertex];
    facts.displacement = mesh.displacement(vertex);
    facts.length = glm::length(glm::dvec3(facts.current) - glm::dvec3(facts.original));
    bool first = true;
    for (const std::uint32_t render : mesh.render().renderVerticesOf(vertex)) {
        if (render >= mesh.render().drawnVertices) {
            break;  // of no face
        }
        const glm::vec3& before = mesh.render().vertices[render].normal;
        const glm::vec3& now = mesh.vertices()[render].normal;
        const double turned = before == now ? 0.0 : angleBetween(before, now);
        if (first || turned > facts.turned) {
            facts.normal = now;
            facts.turned = turned;
        }
        first = false;
    }
    return facts;
}

QString vertexNumberText(std::uint32_t vertex) {
    return countText(std::size_t{vertex} + 1);
}

}  // namespace hitscope
