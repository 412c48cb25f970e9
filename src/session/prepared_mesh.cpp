// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/prepared_mesh.h"

#include <utility>
#include <vector>

#include "core/parallel.h"
#include "mesh/coarse_triangles.h"

namespace hitscope {

namespace {

std::shared_ptr<const CollisionMesh> collisionMesh(const std::shared_ptr<const RenderMesh>& mesh) {
    std::vector<glm::vec3> vertices;
    vertices.reserve(mesh->vertices.size());
    for (const DynamicVertex& vertex : mesh->vertices) {
        vertices.push_back(vertex.position);
    }
    // The corners stay the render mesh's own: an index more on millions of triangles would be felt.
    return std::make_shared<const CollisionMesh>(std::move(vertices),
                                                 CollisionMesh::Corners(mesh, &mesh->triangles));
}

}  // namespace

PreparedMesh prepareMesh(MeshData mesh) {
    PreparedMesh prepared;
    prepared.mesh = std::make_shared<const MeshData>(std::move(mesh));
    const auto render = std::make_shared<RenderMesh>(buildRenderMesh(*prepared.mesh));
    prepared.render = render;
    bothAtOnce(
        [&prepared, &render] {
            prepared.trueNormals = std::make_shared<const TrueNormals>(prepared.mesh, prepared.render);
            addCoarseTriangles(*render);
        },
        [&prepared] { prepared.collision = collisionMesh(prepared.render); });
    return prepared;
}

}  // namespace hitscope
