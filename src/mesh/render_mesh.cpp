// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/render_mesh.h"

#include <algorithm>
#include <utility>

#include "core/give_up.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "core/raw_vector.h"
#include "core/sorted_by_key.h"
#include "mesh/corner_normals.h"
#include "mesh/render_vertices.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

// Fewer are done sooner than a thread is started.
constexpr std::size_t kVerticesAThread = 8192;
constexpr std::size_t kFacesAThread = 8192;

void makeFileVertexMap(const MeshData& mesh, RenderMesh& render) {
    KeyedNumbers<std::vector<std::uint32_t>> map = sortedByKey<std::vector<std::uint32_t>>(
        render.fileVertices.size(), mesh.vertexCount(),
        [&render](std::size_t vertex) { return render.fileVertices[vertex]; });
    render.fileVertexStarts = std::move(map.starts);
    render.fileVertexRender = std::move(map.numbers);
}

std::uint32_t materialOf(const MeshData& mesh, std::uint32_t face) {
    return mesh.faceMaterials.empty() ? kNoIndex : mesh.faceMaterials[face];
}

/// All faces' triangles in the file's order, as render vertices, and the face of each.
struct FileTriangles {
    RawVector<std::uint32_t> corners;  ///< 3 a triangle
    RawVector<std::uint32_t> faces;    ///< 1 a triangle
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

/// Triangles sorted by material (none last), then by place in space.
RawVector<std::uint32_t> orderOf(const MeshData& mesh, const RenderMesh& render, const FileTriangles& file) {
    RawVector<std::uint32_t> order =
        sortedByKey(file.faces.size(), render.drawnVertices, [&file](std::size_t triangle) {
            const std::uint32_t* const corners = &file.corners[3 * triangle];
            return std::min({corners[0], corners[1], corners[2]});
        }).numbers;
    if (mesh.faceMaterials.empty()) {
        return order;
    }
    const std::size_t none = mesh.materials.size();
    const RawVector<std::uint32_t> places =
        sortedByKey(order.size(), none + 1, [&](std::size_t place) {
            return std::min<std::size_t>(materialOf(mesh, file.faces[order[place]]), none);
        }).numbers;
    RawVector<std::uint32_t> byMaterial(order.size());
    std::transform(places.begin(), places.end(), byMaterial.begin(),
                   [&order](std::uint32_t place) { return order[place]; });
    return byMaterial;
}

void makeDraws(const MeshData& mesh, RenderMesh& render) {
    for (std::size_t triangle = 0; triangle < render.triangleFaces.size(); ++triangle) {
        mayGiveUp(triangle);
        const std::uint32_t material = materialOf(mesh, render.triangleFaces[triangle]);
        if (render.draws.empty() || render.draws.back().material != material) {
            render.draws.push_back({static_cast<std::uint32_t>(3 * triangle), 0, material});
        }
        render.draws.back().count += 3;
    }
}

void makeTriangles(const MeshData& mesh, RenderMesh& render) {
    const FileTriangles file = fileTriangles(mesh, render);
    const RawVector<std::uint32_t> order = orderOf(mesh, render, file);
    render.triangles.resize(file.corners.size());
    render.triangleFaces.resize(file.faces.size());
    inWatchedParts(order.size(), kFacesAThread, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::copy_n(&file.corners[3 * std::size_t{order[i]}], 3, &render.triangles[3 * i]);
            render.triangleFaces[i] = file.faces[order[i]];
        }
    });
    makeDraws(mesh, render);
}

/// Each edge is listed with the lower-numbered of its render vertices, and so in their order; sorting the
/// short lists finds the doubles. Of render vertices [begin, end).
std::vector<std::uint32_t> edgesOf(const MeshData& mesh, const VertexCorners& vertexCorners,
                                   const CornerFaces& cornerFaces, const RenderMesh& render,
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
            const std::uint32_t first = mesh.faceStarts[cornerFaces[corner]];
            const std::uint32_t behind = mesh.faceStarts[cornerFaces[corner] + 1];
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

void makeEdges(const MeshData& mesh, const VertexCorners& vertexCorners, const CornerFaces& cornerFaces,
               RenderMesh& render) {
    const std::size_t count = render.drawnVertices;
    const std::size_t parts = std::clamp<std::size_t>(count / kVerticesAThread, 1, usefulThreads());
    std::vector<std::vector<std::uint32_t>> runs(parts);
    forEachAtOnce(parts, [&](std::size_t part) {
        runs[part] = edgesOf(mesh, vertexCorners, cornerFaces, render, count * part / parts,
                             count * (part + 1) / parts);
    });
    std::vector<std::size_t> starts(parts + 1, 0);
    for (std::size_t part = 0; part < parts; ++part) {
        starts[part + 1] = starts[part] + runs[part].size();
    }
    render.edges.resize(starts.back());
    forEachAtOnce(parts, [&](std::size_t part) {
        std::copy(runs[part].begin(), runs[part].end(),
                  render.edges.begin() + static_cast<std::ptrdiff_t>(starts[part]));
        freeAll(runs[part]);
    });
}

}  // namespace

RenderMesh buildRenderMesh(const MeshData& mesh, float creaseAngle) {
    RenderMesh render;
    const VertexCorners vertexCorners(mesh);
    const CornerFaces cornerFaces(mesh);
    makeRenderVertices(mesh, vertexCorners, CornerNormals(mesh, vertexCorners, cornerFaces, creaseAngle),
                       render);
    makeFileVertexMap(mesh, render);
    makeTriangles(mesh, render);
    render.triangleRuns = ClusterRuns(render.vertices, render.triangles, 3, render.draws);
    makeEdges(mesh, vertexCorners, cornerFaces, render);
    return render;
}

}  // namespace hitscope
