// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of refining have in common.
#pragma once

#include <QTest>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

#include "mesh/refine/refine.h"
#include "mesh/same_bits.h"
#include "mesh/surface/surface_measurer.h"
#include "mesh/surface/surface_topology.h"
#include "mesh/surface/welded_vertices.h"
#include "mesh/triangulate.h"
#include "solids.h"

namespace hitscope::refine_test {

using namespace hitscope::test;

inline constexpr RefineMethod kMethods[] = {RefineMethod::Midpoint, RefineMethod::LongestEdge,
                                            RefineMethod::Butterfly};

inline RefineOptions options(RefineMethod method, float length, bool keepQuads = false) {
    return {.method = method, .edgeLength = length, .keepQuads = keepQuads, .region = {}};
}

inline SurfaceStatistics statisticsOf(const MeshData& mesh) {
    return SurfaceTopology::build(mesh)->statistics();
}

inline MeshData triangulated(const MeshData& mesh) {
    MeshData made = mesh;
    made.cornerTexcoords.clear();
    made.cornerNormals.clear();
    made.cornerVertices.clear();
    made.faceStarts.assign(1, 0);
    Triangulator triangulator;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        std::vector<std::uint32_t> corners;
        triangulator.triangulate(mesh.positions, mesh.face(f), corners);
        for (const std::uint32_t corner : corners) {
            made.cornerVertices.push_back(mesh.face(f)[corner]);
            if (made.cornerVertices.size() % 3 == 0) {
                made.faceStarts.push_back(static_cast<std::uint32_t>(made.cornerVertices.size()));
            }
        }
    }
    return made;
}

inline double area(const MeshData& mesh) {
    double sum = 0.0;
    const MeshData cut = triangulated(mesh);
    for (std::size_t f = 0; f < cut.faceCount(); ++f) {
        sum += 0.5 * glm::length(doubleAreaVector(cut.positions, cut.face(f)));
    }
    return sum;
}

inline double volume(const MeshData& mesh) {
    double sum = 0.0;
    const MeshData cut = triangulated(mesh);
    for (std::size_t f = 0; f < cut.faceCount(); ++f) {
        const auto at = [&](int i) {
            return glm::dvec3(cut.positions[cut.face(f)[static_cast<std::size_t>(i)]]);
        };
        sum += glm::dot(at(0), glm::cross(at(1), at(2))) / 6.0;
    }
    return sum;
}

inline double longestEdge(const MeshData& mesh) {
    double longest = 0.0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            longest =
                std::max(longest, glm::distance(glm::dvec3(mesh.positions[face[i]]),
                                                glm::dvec3(mesh.positions[face[(i + 1) % face.size()]])));
        }
    }
    return longest;
}

/// No vertex is on an edge between two others, which would be a gap as soon as it moves. Looks at every edge
/// of one face only, whose middle a finer neighbour would have.
inline bool hasOpenMiddles(const MeshData& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    const std::vector<std::uint32_t> places = weldedVertices(mesh);
    std::set<std::array<float, 3>> positions;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            ++sides[std::minmax(places[face[i]], places[face[(i + 1) % face.size()]])];
            const glm::vec3& p = mesh.positions[face[i]];
            positions.insert({p.x, p.y, p.z});
        }
    }
    return std::any_of(sides.begin(), sides.end(), [&](const auto& side) {
        const glm::vec3 middle(0.5 * (glm::dvec3(mesh.positions[side.first.first]) +
                                      glm::dvec3(mesh.positions[side.first.second])));
        return side.second == 1 && positions.contains({middle.x, middle.y, middle.z});
    });
}

inline RefinedMesh refined(const MeshData& mesh, const RefineOptions& how) {
    Result<RefinedMesh> result = refine(mesh, how);
    if (!result) {
        qWarning("%s", result.error().message().c_str());
        return {};
    }
    return std::move(result).value();
}

/// What holds whatever is refined and however.
inline void checkKept(const MeshData& before, const RefinedMesh& after) {
    const MeshData& mesh = after.mesh;
    QVERIFY2(validate(mesh).ok(), validate(mesh).ok() ? "" : validate(mesh).error().message().c_str());
    QCOMPARE(after.firstNew, before.vertexCount());
    QCOMPARE(after.parents.size(), mesh.vertexCount() - before.vertexCount());
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        QCOMPARE(mesh.isNew(v), v >= before.vertexCount());
        if (v < before.vertexCount()) {
            QVERIFY(sameBits(mesh.positions[v], before.positions[v]));
            QCOMPARE(mesh.sourceVertices[v], v);
        } else {
            const auto& parents = after.parents[v - after.firstNew];
            QVERIFY(parents[0] < v && parents[1] < v && (parents[2] == kNoIndex || parents[2] < v));
        }
    }
    const SurfaceStatistics was = statisticsOf(before);
    const SurfaceStatistics is = statisticsOf(mesh);
    QCOMPARE(is.watertight, was.watertight);
    QCOMPARE(is.genus, was.genus);
    QCOMPARE(is.eulerCharacteristic, was.eulerCharacteristic);
    QCOMPARE(is.components, was.components);
    QCOMPARE(is.holes, was.holes);
    QCOMPARE(is.orientable, was.orientable);
    QCOMPARE(is.nonManifoldEdges > 0, was.nonManifoldEdges > 0);
    QVERIFY(!hasOpenMiddles(mesh));
}

inline MeshData tetrahedron() {
    return meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

inline MeshRegion ballAt(const glm::vec3& centre, float radius) {
    return {MeshRegion::Kind::Balls, {}, {{centre, radius}}};
}

}  // namespace hitscope::refine_test
