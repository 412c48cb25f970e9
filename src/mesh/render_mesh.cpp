// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/render_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/give_up.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "mesh/corner_normals.h"
#include "mesh/spatial_order.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

// Fewer are done sooner than a thread is started.
constexpr std::size_t kVerticesAThread = 8192;
constexpr std::size_t kFacesAThread = 8192;

/// std::sort() keeps so many equal ones in their order.
constexpr std::size_t kMostKeptInOrder = 16;

/// What makes a corner of a vertex a render vertex of its own.
struct CornerAttributes {
    const MeshData& mesh;
    CornerNormals normals;

    [[nodiscard]] glm::vec2 texcoord(std::uint32_t corner) const {
        const std::uint32_t index = mesh.cornerTexcoords.empty() ? kNoIndex : mesh.cornerTexcoords[corner];
        const glm::vec2 texcoord = index == kNoIndex ? glm::vec2(0.0f) : mesh.texcoords[index];
        return std::isfinite(texcoord.x) && std::isfinite(texcoord.y) ? texcoord : glm::vec2(0.0f);
    }
    [[nodiscard]] auto key(std::uint32_t corner) const {
        const glm::vec3& n = normals[corner];
        const glm::vec2 t = texcoord(corner);
        return std::tuple(n.x, n.y, n.z, t.x, t.y);
    }
};

/// The render vertices of a run of the file's.
struct VertexRun {
    PageVector<DynamicVertex> vertices;
    std::vector<glm::vec2> texcoords;
    std::vector<std::uint32_t> fileVertices;

    void add(const MeshData& mesh, std::size_t v, std::uint32_t corner, const CornerAttributes& attributes) {
        vertices.push_back({mesh.positions[v], attributes.normals[corner]});
        texcoords.push_back(attributes.texcoord(corner));
        fileVertices.push_back(static_cast<std::uint32_t>(v));
    }
};

/// Of vertices [begin, end); their corners get numbers from the run's first on.
VertexRun makeRun(const MeshData& mesh, const VertexCorners& vertexCorners, std::size_t begin,
                  std::size_t end, const CornerAttributes& attributes, std::span<std::uint32_t> numbers) {
    VertexRun run;
    run.vertices.reserve(end - begin);
    run.texcoords.reserve(end - begin);
    run.fileVertices.reserve(end - begin);
    std::vector<std::pair<decltype(attributes.key(0)), std::uint32_t>> sorted;
    for (std::size_t v = begin; v < end; ++v) {
        mayGiveUp(v);
        sorted.clear();
        bool isOne = true;
        for (const std::uint32_t corner : vertexCorners.of(v)) {
            sorted.emplace_back(attributes.key(corner), corner);
            isOne = isOne && sorted.back().first == sorted.front().first;
        }
        if (!isOne || sorted.size() > kMostKeptInOrder) {
            std::sort(sorted.begin(), sorted.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
        }
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            if (i == 0 || sorted[i].first != sorted[i - 1].first) {
                run.add(mesh, v, sorted[i].second, attributes);
            }
            numbers[sorted[i].second] = static_cast<std::uint32_t>(run.vertices.size() - 1);
        }
    }
    return run;
}

/// Fills vertices, texcoords, fileVertices and cornerRenderVertices, in the file's order of vertices.
void makeVertices(const MeshData& mesh, const VertexCorners& vertexCorners,
                  const CornerAttributes& attributes, RenderMesh& render) {
    const std::size_t count = mesh.vertexCount();
    render.cornerRenderVertices.resize(mesh.cornerVertices.size());
    const std::size_t parts = std::clamp<std::size_t>(count / kVerticesAThread, 1, usefulThreads());
    std::vector<VertexRun> runs(parts);
    forEachAtOnce(parts, [&](std::size_t part) {
        runs[part] = makeRun(mesh, vertexCorners, count * part / parts, count * (part + 1) / parts,
                             attributes, render.cornerRenderVertices);
    });
    render.vertices = std::move(runs[0].vertices);
    render.texcoords = std::move(runs[0].texcoords);
    render.fileVertices = std::move(runs[0].fileVertices);
    for (std::size_t part = 1; part < parts; ++part) {
        const auto before = static_cast<std::uint32_t>(render.vertices.size());
        const VertexRun run = std::exchange(runs[part], {});
        render.vertices.insert(render.vertices.end(), run.vertices.begin(), run.vertices.end());
        render.texcoords.insert(render.texcoords.end(), run.texcoords.begin(), run.texcoords.end());
        render.fileVertices.insert(render.fileVertices.end(), run.fileVertices.begin(),
                                   run.fileVertices.end());
        for (std::size_t v = count * part / parts; v < count * (part + 1) / parts; ++v) {
            mayGiveUp(v);
            for (const std::uint32_t corner : vertexCorners.of(v)) {
                render.cornerRenderVertices[corner] += before;
            }
        }
    }
    render.drawnVertices = static_cast<std::uint32_t>(render.vertices.size());
    for (std::size_t v = 0; v < count; ++v) {
        mayGiveUp(v);
        if (vertexCorners.of(v).empty()) {
            render.vertices.push_back({mesh.positions[v], glm::vec3(0.0f)});
            render.texcoords.emplace_back(0.0f);
            render.fileVertices.push_back(static_cast<std::uint32_t>(v));
        }
    }
}

template <class Values>
Values permuted(const Values& values, std::span<const std::uint32_t> order) {
    Values result;
    result.reserve(values.size());
    for (const std::uint32_t index : order) {
        mayGiveUp(result.size());
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
        mayGiveUp(i);
        placeOf[order[i]] = static_cast<std::uint32_t>(i);
    }
    for (std::size_t c = 0; c < render.cornerRenderVertices.size(); ++c) {
        mayGiveUp(c);
        render.cornerRenderVertices[c] = placeOf[render.cornerRenderVertices[c]];
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
        mayGiveUp(i);
        render.fileVertexRender[next[render.fileVertices[i]]++] = static_cast<std::uint32_t>(i);
    }
}

std::uint32_t materialOf(const MeshData& mesh, std::uint32_t face) {
    return mesh.faceMaterials.empty() ? kNoIndex : mesh.faceMaterials[face];
}

/// All faces' triangles in the file's order, as render vertices, and the face of each.
struct FileTriangles {
    std::vector<std::uint32_t> corners;  ///< 3 a triangle
    std::vector<std::uint32_t> faces;    ///< 1 a triangle
};

/// A face of n corners has n - 2 triangles: so those before it are known.
void cutFaces(const MeshData& mesh, const RenderMesh& render, std::size_t begin, std::size_t end,
              Triangulator& triangulator, FileTriangles& triangles) {
    std::vector<std::uint32_t> corners;
    for (std::size_t f = begin; f < end; ++f) {
        mayGiveUp(f);
        corners.clear();
        triangulator.triangulate(mesh.positions, mesh.face(f), corners);
        const std::size_t first = mesh.faceStarts[f] - 2 * f;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            triangles.corners[3 * first + i] = render.cornerRenderVertices[mesh.faceStarts[f] + corners[i]];
        }
        std::fill_n(triangles.faces.begin() + static_cast<std::ptrdiff_t>(first), corners.size() / 3,
                    static_cast<std::uint32_t>(f));
    }
}

FileTriangles fileTriangles(const MeshData& mesh, const RenderMesh& render) {
    const std::size_t faces = mesh.faceCount();
    FileTriangles triangles;
    triangles.faces.resize(mesh.cornerVertices.size() - 2 * faces);
    triangles.corners.resize(3 * triangles.faces.size());
    const std::size_t parts = std::clamp<std::size_t>(faces / kFacesAThread, 1, usefulThreads());
    std::vector<Triangulator> triangulators(parts);
    forEachAtOnce(parts, [&](std::size_t part) {
        cutFaces(mesh, render, faces * part / parts, faces * (part + 1) / parts, triangulators[part],
                 triangles);
    });
    if (parts > 1 && !Triangulator::areAsOne(triangulators)) {
        Triangulator alone;
        cutFaces(mesh, render, 0, faces, alone, triangles);
    }
    return triangles;
}

/// 0 .. keys.size() - 1, sorted by their keys < count, equal ones as `order` has them.
template <class Key>
std::vector<std::uint32_t> sortedBy(const std::vector<std::uint32_t>& order, std::size_t count,
                                    const Key& key) {
    std::vector<std::uint32_t> starts(count + 1, 0);
    for (const std::uint32_t index : order) {
        ++starts[key(index) + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<std::uint32_t> sorted(order.size());
    std::size_t done = 0;
    for (const std::uint32_t index : order) {
        mayGiveUp(done++);
        sorted[starts[key(index)]++] = index;
    }
    return sorted;
}

/// Triangles sorted by material (none last), then by place in space.
void makeTriangles(const MeshData& mesh, RenderMesh& render) {
    const FileTriangles file = fileTriangles(mesh, render);
    std::vector<std::uint32_t> order(file.faces.size());
    std::iota(order.begin(), order.end(), 0u);
    order = sortedBy(order, render.drawnVertices, [&file](std::uint32_t t) {
        const std::uint32_t* corners = &file.corners[3 * std::size_t{t}];
        return std::min({corners[0], corners[1], corners[2]});
    });
    if (!mesh.faceMaterials.empty()) {
        const std::size_t none = mesh.materials.size();
        order = sortedBy(order, none + 1, [&](std::uint32_t t) {
            return std::min<std::size_t>(materialOf(mesh, file.faces[t]), none);
        });
    }
    render.triangles.reserve(file.corners.size());
    render.triangleFaces.reserve(file.faces.size());
    for (const std::uint32_t t : order) {
        mayGiveUp(render.triangleFaces.size());
        const std::uint32_t material = materialOf(mesh, file.faces[t]);
        if (render.draws.empty() || render.draws.back().material != material) {
            render.draws.push_back({static_cast<std::uint32_t>(render.triangles.size()), 0, material});
        }
        render.draws.back().count += 3;
        const std::uint32_t* corners = &file.corners[3 * std::size_t{t}];
        render.triangles.insert(render.triangles.end(), corners, corners + 3);
        render.triangleFaces.push_back(file.faces[t]);
    }
}

/// Each edge is listed with the lower-numbered of its render vertices, and so in their order; sorting the
/// short lists finds the doubles. Of render vertices [begin, end).
std::vector<std::uint32_t> edgesOf(const MeshData& mesh, const VertexCorners& vertexCorners,
                                   const std::vector<std::uint32_t>& faceOfCorner, const RenderMesh& render,
                                   std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> edges;
    std::vector<std::uint32_t> neighbours;
    for (auto r = static_cast<std::uint32_t>(begin); r < end; ++r) {
        mayGiveUp(r);
        const std::uint32_t v = render.fileVertices[r];
        if (render.renderVerticesOf(v).front() != r) {
            continue;
        }
        neighbours.clear();
        for (const std::uint32_t corner : vertexCorners.of(v)) {
            const std::uint32_t first = mesh.faceStarts[faceOfCorner[corner]];
            const std::uint32_t behind = mesh.faceStarts[faceOfCorner[corner] + 1];
            for (const std::uint32_t other :
                 {corner + 1 < behind ? corner + 1 : first, corner > first ? corner - 1 : behind - 1}) {
                const std::uint32_t neighbour = render.renderVerticesOf(mesh.cornerVertices[other]).front();
                if (neighbour > r) {
                    neighbours.push_back(neighbour);
                }
            }
        }
        std::sort(neighbours.begin(), neighbours.end());
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        for (const std::uint32_t neighbour : neighbours) {
            edges.push_back(r);
            edges.push_back(neighbour);
        }
    }
    return edges;
}

void makeEdges(const MeshData& mesh, const VertexCorners& vertexCorners, RenderMesh& render) {
    std::vector<std::uint32_t> faceOfCorner(mesh.cornerVertices.size());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        mayGiveUp(f);
        std::fill(faceOfCorner.begin() + mesh.faceStarts[f], faceOfCorner.begin() + mesh.faceStarts[f + 1],
                  static_cast<std::uint32_t>(f));
    }
    const std::size_t count = render.drawnVertices;
    const std::size_t parts = std::clamp<std::size_t>(count / kVerticesAThread, 1, usefulThreads());
    std::vector<std::vector<std::uint32_t>> runs(parts);
    forEachAtOnce(parts, [&](std::size_t part) {
        runs[part] = edgesOf(mesh, vertexCorners, faceOfCorner, render, count * part / parts,
                             count * (part + 1) / parts);
    });
    freeAll(faceOfCorner);
    std::size_t edges = 0;
    for (const std::vector<std::uint32_t>& run : runs) {
        edges += run.size();
    }
    render.edges.reserve(edges);
    for (std::vector<std::uint32_t>& run : runs) {
        render.edges.insert(render.edges.end(), run.begin(), run.end());
        freeAll(run);
    }
}

}  // namespace

RenderMesh buildRenderMesh(const MeshData& mesh, float creaseAngle) {
    RenderMesh render;
    const VertexCorners vertexCorners(mesh);
    makeVertices(mesh, vertexCorners, {mesh, CornerNormals(mesh, vertexCorners, creaseAngle)}, render);
    orderVertices(render);
    makeFileVertexMap(mesh, render);
    makeTriangles(mesh, render);
    render.triangleRuns = ClusterRuns(render.vertices, render.triangles, 3, render.draws);
    makeEdges(mesh, vertexCorners, render);
    return render;
}

}  // namespace hitscope
