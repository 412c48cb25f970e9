// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/connectivity.h"
#include "mesh/face_measure.h"

namespace hitscope {
namespace {

std::size_t countEdges(const MeshData& mesh) {
    std::vector<std::uint64_t> edges;
    edges.reserve(mesh.cornerVertices.size());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto [low, high] = std::minmax(face[i], face[(i + 1) % face.size()]);
            if (low != high) {
                edges.push_back(std::uint64_t{low} << 32 | high);
            }
        }
    }
    std::sort(edges.begin(), edges.end());
    return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

std::size_t countUnreferenced(const MeshData& mesh) {
    std::vector<bool> used(mesh.vertexCount(), false);
    for (const std::uint32_t vertex : mesh.cornerVertices) {
        used[vertex] = true;
    }
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

}  // namespace

TopologyStatistics computeTopology(const MeshData& mesh) {
    TopologyStatistics statistics;
    statistics.vertices = mesh.vertexCount();
    statistics.unreferencedVertices = countUnreferenced(mesh);
    statistics.edges = countEdges(mesh);
    statistics.faces = mesh.faceCount();
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const std::size_t corners = mesh.face(f).size();
        statistics.triangles += corners == 3 ? 1 : 0;
        statistics.quads += corners == 4 ? 1 : 0;
        statistics.largerPolygons += corners > 4 ? 1 : 0;
        statistics.degenerateFaces += repeatsVertex(mesh.face(f)) ? 1 : 0;
    }

    const Connectivity connectivity = connect(mesh);
    statistics.boundaryEdges = connectivity.boundaryEdges;
    statistics.components = connectivity.components;
    statistics.nonManifoldFaces = connectivity.refused;
    const bool isWhole = statistics.degenerateFaces == 0 && statistics.nonManifoldFaces == 0;
    if (isWhole) {
        statistics.eulerCharacteristic = static_cast<long long>(connectivity.vertices) -
                                         static_cast<long long>(connectivity.edges) +
                                         static_cast<long long>(connectivity.faces);
    }
    statistics.watertight = isWhole && statistics.faces > 0 && statistics.boundaryEdges == 0;
    return statistics;
}

GeometryStatistics computeGeometry(const MeshData& mesh, std::span<const glm::vec3> positions,
                                   const TopologyStatistics& topology) {
    GeometryStatistics statistics;
    for (const glm::vec3& position : positions) {
        statistics.bounds.add(position);
    }
    // Measured from the middle of the mesh, far from the origin the volumes would cancel out in rounding.
    const glm::dvec3 reference(statistics.bounds.centre());
    double volume = 0.0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const FaceMeasure face = measureFace(positions, mesh.face(f), reference);
        statistics.surfaceArea += face.area;
        volume += face.volume;
    }
    if (topology.watertight) {
        statistics.volume = std::abs(volume);
    }
    return statistics;
}

}  // namespace hitscope
