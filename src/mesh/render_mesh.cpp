// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/render_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "mesh/corner_normals.h"
#include "mesh/spatial_order.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

/// Everything of a corner but its vertex that makes it a render vertex of its own.
struct CornerAttributes {
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texcoords;

    [[nodiscard]] auto key(std::uint32_t corner) const {
        const glm::vec3& n = normals[corner];
        const glm::vec2& t = texcoords[corner];
        return std::tuple(n.x, n.y, n.z, t.x, t.y);
    }
};

std::vector<glm::vec2> cornerTexcoords(const MeshData& mesh) {
    std::vector<glm::vec2> texcoords(mesh.cornerVertices.size(), glm::vec2(0.0f));
    for (std::size_t c = 0; c < mesh.cornerTexcoords.size(); ++c) {
        if (mesh.cornerTexcoords[c] == kNoIndex) {
            continue;
        }
        const glm::vec2& texcoord = mesh.texcoords[mesh.cornerTexcoords[c]];
        if (std::isfinite(texcoord.x) && std::isfinite(texcoord.y)) {
            texcoords[c] = texcoord;
        }
    }
    return texcoords;
}

/// Fills vertices, texcoords, fileVertices and cornerRenderVertices, in the file's order of vertices.
void makeVertices(const MeshData& mesh, const VertexCorners& vertexCorners,
                  const CornerAttributes& attributes, RenderMesh& render) {
    render.cornerRenderVertices.resize(mesh.cornerVertices.size());
    std::vector<std::uint32_t> corners;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        const auto around = vertexCorners.of(v);
        corners.assign(around.begin(), around.end());
        std::sort(corners.begin(), corners.end(), [&attributes](std::uint32_t a, std::uint32_t b) {
            return attributes.key(a) < attributes.key(b);
        });
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (i == 0 || attributes.key(corners[i]) != attributes.key(corners[i - 1])) {
                render.vertices.push_back({mesh.positions[v], attributes.normals[corners[i]]});
                render.texcoords.push_back(attributes.texcoords[corners[i]]);
                render.fileVertices.push_back(static_cast<std::uint32_t>(v));
            }
            render.cornerRenderVertices[corners[i]] = static_cast<std::uint32_t>(render.vertices.size() - 1);
        }
    }
    render.drawnVertices = static_cast<std::uint32_t>(render.vertices.size());
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        if (vertexCorners.of(v).empty()) {
            render.vertices.push_back({mesh.positions[v], glm::vec3(0.0f)});
            render.texcoords.emplace_back(0.0f);
            render.fileVertices.push_back(static_cast<std::uint32_t>(v));
        }
    }
}

template <class T>
std::vector<T> permuted(const std::vector<T>& values, std::span<const std::uint32_t> order) {
    std::vector<T> result;
    result.reserve(values.size());
    for (const std::uint32_t index : order) {
        result.push_back(values[index]);
    }
    return result;
}

/// Those that are drawn by place, and then the others by place.
std::vector<std::uint32_t> orderOf(const RenderMesh& render) {
    std::vector<glm::vec3> points;
    points.reserve(render.vertices.size());
    for (const DynamicVertex& vertex : render.vertices) {
        points.push_back(vertex.position);
    }
    const auto all = std::span<const glm::vec3>(points);
    std::vector<std::uint32_t> order = spatialOrder(all.first(render.drawnVertices));
    for (const std::uint32_t other : spatialOrder(all.subspan(render.drawnVertices))) {
        order.push_back(render.drawnVertices + other);
    }
    return order;
}

void makeClusters(RenderMesh& render) {
    const auto count = static_cast<std::uint32_t>(render.vertices.size());
    for (std::uint32_t first = 0; first < count; first += kClusterVertices) {
        Cluster cluster{first, std::min(kClusterVertices, count - first), {}};
        for (const DynamicVertex& vertex : std::span(render.vertices).subspan(first, cluster.count)) {
            cluster.bounds.add(vertex.position);
        }
        render.clusters.push_back(cluster);
    }
}

void orderVertices(RenderMesh& render) {
    const std::vector<std::uint32_t> order = orderOf(render);
    render.vertices = permuted(render.vertices, order);
    render.texcoords = permuted(render.texcoords, order);
    render.fileVertices = permuted(render.fileVertices, order);
    for (const DynamicVertex& vertex : std::span(render.vertices).first(render.drawnVertices)) {
        render.bounds.add(vertex.position);
    }
    makeClusters(render);

    std::vector<std::uint32_t> placeOf(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        placeOf[order[i]] = static_cast<std::uint32_t>(i);
    }
    for (std::uint32_t& vertex : render.cornerRenderVertices) {
        vertex = placeOf[vertex];
    }
}

void makeFileVertexMap(const MeshData& mesh, RenderMesh& render) {
    render.fileVertexStarts.assign(mesh.vertexCount() + 1, 0);
    for (const std::uint32_t vertex : render.fileVertices) {
        ++render.fileVertexStarts[vertex + 1];
    }
    std::partial_sum(render.fileVertexStarts.begin(), render.fileVertexStarts.end(),
                     render.fileVertexStarts.begin());
    std::vector<std::uint32_t> next(render.fileVertexStarts.begin(), render.fileVertexStarts.end() - 1);
    render.fileVertexRender.resize(render.fileVertices.size());
    for (std::size_t i = 0; i < render.fileVertices.size(); ++i) {
        render.fileVertexRender[next[render.fileVertices[i]]++] = static_cast<std::uint32_t>(i);
    }
}

std::uint32_t materialOf(const MeshData& mesh, std::uint32_t face) {
    return mesh.faceMaterials.empty() ? kNoIndex : mesh.faceMaterials[face];
}

/// Triangles sorted by material (none last), then by place in space.
void makeTriangles(const MeshData& mesh, RenderMesh& render) {
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> corners;
    Triangulator triangulator;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        corners.clear();
        triangulator.triangulate(mesh.positions, mesh.face(f), corners);
        for (const std::uint32_t corner : corners) {
            triangles.push_back(render.cornerRenderVertices[mesh.faceStarts[f] + corner]);
        }
        faces.insert(faces.end(), corners.size() / 3, static_cast<std::uint32_t>(f));
    }

    struct Entry {
        std::uint64_t key;
        std::uint32_t triangle;
    };
    std::vector<Entry> entries;
    entries.reserve(faces.size());
    for (std::size_t t = 0; t < faces.size(); ++t) {
        const std::uint32_t lowest = std::min({triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]});
        entries.push_back(
            {std::uint64_t{materialOf(mesh, faces[t])} << 32 | lowest, static_cast<std::uint32_t>(t)});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
    });
    render.triangles.reserve(triangles.size());
    render.triangleFaces.reserve(faces.size());
    for (const Entry& entry : entries) {
        const std::size_t t = entry.triangle;
        const std::uint32_t material = materialOf(mesh, faces[t]);
        if (render.draws.empty() || render.draws.back().material != material) {
            render.draws.push_back({static_cast<std::uint32_t>(render.triangles.size()), 0, material});
        }
        render.draws.back().count += 3;
        render.triangles.insert(render.triangles.end(),
                                {triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]});
        render.triangleFaces.push_back(faces[t]);
    }
}

/// Each edge is listed with the lower-numbered of its render vertices, and so in their order; sorting the
/// short lists finds the doubles.
void makeEdges(const MeshData& mesh, const VertexCorners& vertexCorners, RenderMesh& render) {
    std::vector<std::uint32_t> nextCorner(mesh.cornerVertices.size());
    std::vector<std::uint32_t> previousCorner(mesh.cornerVertices.size());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const std::uint32_t first = mesh.faceStarts[f];
        const std::uint32_t end = mesh.faceStarts[f + 1];
        for (std::uint32_t c = first; c < end; ++c) {
            const std::uint32_t after = c + 1 < end ? c + 1 : first;
            nextCorner[c] = after;
            previousCorner[after] = c;
        }
    }
    std::vector<std::uint32_t> neighbours;
    for (std::uint32_t r = 0; r < render.drawnVertices; ++r) {
        const std::uint32_t v = render.fileVertices[r];
        if (render.renderVerticesOf(v).front() != r) {
            continue;
        }
        neighbours.clear();
        for (const std::uint32_t corner : vertexCorners.of(v)) {
            for (const std::uint32_t other : {nextCorner[corner], previousCorner[corner]}) {
                const std::uint32_t neighbour = render.renderVerticesOf(mesh.cornerVertices[other]).front();
                if (neighbour > r) {
                    neighbours.push_back(neighbour);
                }
            }
        }
        std::sort(neighbours.begin(), neighbours.end());
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        for (const std::uint32_t neighbour : neighbours) {
            render.edges.push_back(r);
            render.edges.push_back(neighbour);
        }
    }
}

}  // namespace

RenderMesh buildRenderMesh(const MeshData& mesh, float creaseAngle) {
    RenderMesh render;
    const VertexCorners vertexCorners(mesh);
    makeVertices(mesh, vertexCorners,
                 {cornerNormals(mesh, vertexCorners, creaseAngle), cornerTexcoords(mesh)}, render);
    orderVertices(render);
    makeFileVertexMap(mesh, render);
    makeTriangles(mesh, render);
    makeEdges(mesh, vertexCorners, render);
    return render;
}

}  // namespace hitscope
