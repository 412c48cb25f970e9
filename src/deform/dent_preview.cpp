// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/dent_preview.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "deform/deform.h"

namespace hitscope {

namespace {

/// Render vertex and where it would be; ascending.
using Moved = std::vector<std::pair<std::uint32_t, glm::vec3>>;

const glm::vec3* findMoved(const Moved& moved, std::uint32_t vertex) {
    const auto at = std::lower_bound(moved.begin(), moved.end(), vertex,
                                     [](const auto& entry, std::uint32_t v) { return entry.first < v; });
    return at != moved.end() && at->first == vertex ? &at->second : nullptr;
}

}  // namespace

DentPreview previewDent(const RenderMesh& mesh, std::span<const DynamicVertex> current,
                        std::span<const VertexRange> reach, std::span<const std::uint32_t> triangles,
                        const Hit& hit) {
    DentPreview preview;
    Moved moved;
    std::vector<std::uint32_t> fileVertices;
    const DentShape shape = dentShapeOf(hit);
    for (const VertexRange& range : reach) {
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            DynamicVertex vertex = current[i];
            // A move that is rounded away is none.
            if (deform(vertex.position, vertex.normal, shape) && vertex.position != current[i].position) {
                moved.emplace_back(i, vertex.position);
                fileVertices.push_back(mesh.fileVertices[i]);
                preview.depth = std::max(preview.depth, glm::distance(vertex.position, current[i].position));
            }
        }
    }
    std::sort(fileVertices.begin(), fileVertices.end());
    preview.affectedVertices = static_cast<std::size_t>(
        std::unique(fileVertices.begin(), fileVertices.end()) - fileVertices.begin());
    for (const std::uint32_t triangle : triangles) {
        const std::uint32_t* corners = &mesh.triangles[std::size_t{3} * triangle];
        const glm::vec3* places[3] = {findMoved(moved, corners[0]), findMoved(moved, corners[1]),
                                      findMoved(moved, corners[2])};
        if (places[0] == nullptr && places[1] == nullptr && places[2] == nullptr) {
            continue;
        }
        for (int i = 0; i < 3; ++i) {
            preview.dent.push_back(places[i] != nullptr ? *places[i] : current[corners[i]].position);
        }
    }
    return preview;
}

std::vector<VertexRange> clustersNear(const RenderMesh& mesh, std::span<const Bounds> boxes,
                                      const glm::vec3& point, float distance) {
    // A little farther, since the distance to a vertex is rounded otherwise than that to a box.
    const float reach = distance * 1.0001f;
    std::vector<VertexRange> near;
    for (std::size_t i = 0; i < mesh.clusters.size(); ++i) {
        const glm::vec3 away =
            glm::max(glm::max(boxes[i].min - point, point - boxes[i].max), glm::vec3(0.0f));
        if (!boxes[i].empty() && glm::dot(away, away) <= reach * reach) {
            near.push_back({mesh.clusters[i].first, mesh.clusters[i].count});
        }
    }
    return merged(std::move(near));
}

}  // namespace hitscope
