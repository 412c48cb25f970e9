// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "mesh/primitives.h"
#include "mesh/render_mesh.h"
#include "mesh/teapot.h"
#include "mesh_support.h"
#include "support/test_program.h"

namespace hitscope::mesh_render_test {

using test::meshOf;
using test::withoutNormals;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A cube whose corners are shared and that has no normals.
MeshData plainCube() {
    return withoutNormals(makeCube(1, 1.0f));
}

MeshData mixedMaterials() {
    MeshData mesh = makeCube(8, 1.0f);
    mesh.materials.resize(3);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        mesh.faceMaterials.push_back(f % 4 == 3 ? kNoIndex : static_cast<std::uint32_t>(f % 4));
    }
    return mesh;
}

std::size_t distinctNormals(const RenderMesh& render) {
    std::set<std::tuple<float, float, float>> normals;
    for (const DynamicVertex& v : render.vertices) {
        normals.insert({v.normal.x, v.normal.y, v.normal.z});
    }
    return normals.size();
}

}  // namespace

class RenderMeshTest : public QObject {
    Q_OBJECT

    static void addMeshes() {
        QTest::addColumn<MeshData>("mesh");
        QTest::newRow("nothing") << MeshData();
        QTest::newRow("no faces") << meshOf({{1, 2, 3}}, {});
        QTest::newRow("Low-poly cube") << makeLowPolyCube();
        QTest::newRow("High-poly cube") << makeHighPolyCube();
        QTest::newRow("High-poly sphere") << makeHighPolySphere();
        QTest::newRow("sphere without normals") << withoutNormals(makeLowPolySphere());
        QTest::newRow("teapot") << makeTeapot(9);
        QTest::newRow("materials") << mixedMaterials();
        QTest::newRow("arrowhead") << test::polygon({{0, 2}, {0, 0}, {-2, 0}, {0, -4}, {2, 0}});
        QTest::newRow("loose vertices and a repeated one") << meshOf(
            {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 8, 8}}, {{1, 2, 3}, {1, 1, 2}, {3, 2, 3, 1}});
        QTest::newRow("all in one place") << meshOf(PageVector<glm::vec3>(900), [] {
            std::vector<std::vector<std::uint32_t>> faces;
            for (std::uint32_t i = 0; i + 2 < 900; ++i) {
                faces.push_back({i, i + 1, i + 2});
            }
            return faces;
        }());
    }

private Q_SLOTS:
    void arraysFitTogether_data() { addMeshes(); }
    void arraysFitTogether() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        const std::size_t count = render.vertices.size();
        QCOMPARE(render.texcoords.size(), count);
        QCOMPARE(render.fileVertices.size(), count);
        QCOMPARE(render.cornerRenderVertices.size(), mesh.cornerVertices.size());
        for (std::size_t c = 0; c < mesh.cornerVertices.size(); ++c) {
            const std::uint32_t r = render.cornerRenderVertices[c];
            QVERIFY(r < count);
            QCOMPARE(render.fileVertices[r], mesh.cornerVertices[c]);
        }
        for (std::size_t r = 0; r < count; ++r) {
            QVERIFY(render.vertices[r].position == mesh.positions[render.fileVertices[r]]);
            const float length = r < render.drawnVertices ? 1.0f : 0.0f;  // of no face: none
            QVERIFY(std::abs(glm::length(render.vertices[r].normal) - length) < 1e-6f);
        }
        QCOMPARE(render.fileVertexStarts.size(), mesh.vertexCount() + 1);
        std::size_t listed = 0;
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            for (const std::uint32_t r : render.renderVerticesOf(v)) {
                QCOMPARE(render.fileVertices[r], v);
                ++listed;
            }
        }
        QCOMPARE(listed, count);
    }

    void clustersCoverAndEnclose_data() { addMeshes(); }
    void clustersCoverAndEnclose() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        std::uint32_t next = 0;
        for (const Cluster& cluster : render.clusters) {
            QCOMPARE(cluster.first, next);
            QVERIFY(cluster.count > 0 && cluster.count <= kClusterVertices);
            next += cluster.count;
            for (std::uint32_t r = cluster.first; r < next; ++r) {
                QVERIFY(glm::all(glm::lessThanEqual(cluster.bounds.min, render.vertices[r].position)));
                QVERIFY(glm::all(glm::lessThanEqual(render.vertices[r].position, cluster.bounds.max)));
                if (r >= render.drawnVertices) {
                    continue;
                }
                QVERIFY(glm::all(glm::lessThanEqual(render.bounds.min, render.vertices[r].position)));
                QVERIFY(glm::all(glm::lessThanEqual(render.vertices[r].position, render.bounds.max)));
            }
        }
        QCOMPARE(std::size_t{next}, render.vertices.size());
        QCOMPARE(render.clusters.size(), (render.vertices.size() + kClusterVertices - 1) / kClusterVertices);
    }

    void trianglesAreTheFaces_data() { addMeshes(); }
    void trianglesAreTheFaces() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        QCOMPARE(render.triangles.size(), 3 * render.triangleFaces.size());
        std::map<std::uint32_t, std::size_t> trianglesOf;
        std::map<std::uint32_t, glm::dvec3> areaOf;
        for (std::size_t t = 0; t < render.triangleFaces.size(); ++t) {
            const std::uint32_t face = render.triangleFaces[t];
            ++trianglesOf[face];
            glm::dvec3 p[3];
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t r = render.triangles[3 * t + i];
                const auto corners = mesh.face(face);
                QVERIFY(std::find(corners.begin(), corners.end(), render.fileVertices[r]) != corners.end());
                p[i] = glm::dvec3(render.vertices[r].position);
            }
            areaOf[face] += glm::cross(p[1] - p[0], p[2] - p[0]);
        }
        for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
            QCOMPARE(trianglesOf[f], mesh.face(f).size() - 2);
            glm::dvec3 area(0.0);
            for (std::size_t i = 1; i + 1 < mesh.face(f).size(); ++i) {
                const glm::dvec3 a(mesh.positions[mesh.face(f)[0]]);
                area += glm::cross(glm::dvec3(mesh.positions[mesh.face(f)[i]]) - a,
                                   glm::dvec3(mesh.positions[mesh.face(f)[i + 1]]) - a);
            }
            QVERIFY(glm::distance(area, areaOf[f]) < 1e-9);
        }
    }

    void drawsCoverByMaterial_data() { addMeshes(); }
    void drawsCoverByMaterial() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        std::uint32_t next = 0;
        std::set<std::uint32_t> materials;
        for (const DrawRange& draw : render.draws) {
            QCOMPARE(draw.first, next);
            QVERIFY(materials.insert(draw.material).second);
            for (std::uint32_t i = draw.first / 3; i < (draw.first + draw.count) / 3; ++i) {
                QCOMPARE(draw.material,
                         mesh.faceMaterials.empty() ? kNoIndex : mesh.faceMaterials[render.triangleFaces[i]]);
            }
            next += draw.count;
        }
        QCOMPARE(std::size_t{next}, render.triangles.size());
    }

    void edgesAreThePolygonsOnce_data() { addMeshes(); }
    void edgesAreThePolygonsOnce() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
        for (std::size_t e = 0; e < render.edges.size(); e += 2) {
            const auto [a, b] =
                std::minmax(render.fileVertices[render.edges[e]], render.fileVertices[render.edges[e + 1]]);
            QVERIFY(a != b);
            QVERIFY(seen.insert({a, b}).second);
        }
        std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            for (std::size_t i = 0; i < mesh.face(f).size(); ++i) {
                const auto [a, b] = std::minmax(mesh.face(f)[i], mesh.face(f)[(i + 1) % mesh.face(f).size()]);
                if (a != b) {
                    wanted.insert({a, b});
                }
            }
        }
        QVERIFY(seen == wanted);
    }

    void onlyDifferentCornersAreSplit() {
        // A seam of 20 + 1 columns, and a texture point for each triangle at the poles.
        QCOMPARE(buildRenderMesh(makeLowPolySphere()).vertices.size(), std::size_t{19 * 21 + 2 * 20});
        // Every face of the cube has its own normal.
        QCOMPARE(buildRenderMesh(makeLowPolyCube()).vertices.size(), std::size_t{6 * 9 * 9});
        MeshData sphere = makeLowPolySphere();
        sphere.texcoords.clear();
        sphere.cornerTexcoords.clear();
        QCOMPARE(buildRenderMesh(sphere).vertices.size(), std::size_t{382});
        // Equal values under different indices are one vertex.
        MeshData square = test::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        square = meshOf(square.positions, {{0, 1, 2}, {0, 2, 3}});
        square.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
        square.cornerTexcoords = {0, 1, 2, 3, 4, 5};
        QCOMPARE(buildRenderMesh(square).vertices.size(), std::size_t{4});
        // Vertices in one place stay two, since the file has two.
        QCOMPARE(buildRenderMesh(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{0, 1, 2}, {3, 1, 2}}))
                     .vertices.size(),
                 std::size_t{4});
    }

    void creasesDecideComputedNormals() {
        QCOMPARE(buildRenderMesh(plainCube()).vertices.size(), std::size_t{24});
        QCOMPARE(distinctNormals(buildRenderMesh(plainCube())), std::size_t{6});
        MeshData smooth = plainCube();
        smooth.texcoords.clear();
        smooth.cornerTexcoords.clear();
        QCOMPARE(buildRenderMesh(smooth, 1.6f).vertices.size(), std::size_t{8});
        const MeshData sphere = withoutNormals(makeHighPolySphere(1.0f));
        for (const DynamicVertex& vertex : buildRenderMesh(sphere).vertices) {
            QVERIFY(glm::dot(vertex.normal, vertex.position) > 0.999f);
        }
    }

    void computedNormalsAreWeightedByArea() {
        // Two triangles at an angle of 30 degrees along the x axis, the second twice as large.
        const float c = std::cos(glm::radians(30.0f));
        const float s = std::sin(glm::radians(30.0f));
        const RenderMesh render = buildRenderMesh(
            meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -2 * c, 2 * s}}, {{0, 1, 2}, {1, 0, 3}}));
        QCOMPARE(render.vertices.size(), std::size_t{4});
        const glm::vec3 expected = glm::normalize(glm::vec3(0, 0, 1) + 2.0f * glm::vec3(0, s, c));
        QVERIFY(glm::distance(render.vertices[render.renderVerticesOf(0).front()].normal, expected) < 1e-6f);
        QVERIFY(glm::distance(render.vertices[render.renderVerticesOf(3).front()].normal,
                              glm::vec3(0, s, c)) < 1e-6f);
    }

    void smoothingGroupsOverrideCreases() {
        MeshData cube = plainCube();
        cube.texcoords.clear();
        cube.cornerTexcoords.clear();
        cube.faceSmoothing.assign(6, 1);
        QCOMPARE(buildRenderMesh(cube).vertices.size(), std::size_t{8});
        cube.faceSmoothing.assign(6, 0);
        QCOMPARE(buildRenderMesh(cube, 3.2f).vertices.size(), std::size_t{24});
        MeshData sphere = withoutNormals(makeLowPolySphere());
        sphere.faceSmoothing.assign(sphere.faceCount(), 0);
        QCOMPARE(buildRenderMesh(sphere).vertices.size(), sphere.cornerVertices.size());
    }

    /// The tip of a cone with many sides: comparing each face there with each other would take minutes.
    void theHubOfAFanIsAveraged() {
        constexpr std::uint32_t kSides = 200000;
        PageVector<glm::vec3> positions{{0, 0, 1}};
        std::vector<std::vector<std::uint32_t>> faces;
        for (std::uint32_t i = 0; i < kSides; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / kSides;
            positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
            faces.push_back({0, 1 + i, 1 + (i + 1) % kSides});
        }
        const RenderMesh render = buildRenderMesh(meshOf(positions, faces));
        QCOMPARE(render.renderVerticesOf(0).size(), std::size_t{1});
        QVERIFY(glm::distance(render.vertices[render.renderVerticesOf(0).front()].normal,
                              glm::vec3(0, 0, 1)) < 1e-4f);
    }

    void unusableNumbersAreReplaced() {
        MeshData mesh = test::polygon({{0, 0}, {1, 0}, {0, 1}});
        mesh.normals = {{0, 0, 0}, {kNan, 0, 1}, {0, 0, 5}};
        mesh.cornerNormals = {0, 1, 2};
        mesh.texcoords = {{kNan, 0}, {1, 1}};
        mesh.cornerTexcoords = {0, 1, kNoIndex};
        const RenderMesh render = buildRenderMesh(mesh);
        QCOMPARE(render.vertices.size(), std::size_t{3});
        for (const DynamicVertex& vertex : render.vertices) {
            QVERIFY(vertex.normal == glm::vec3(0, 0, 1));
        }
        QVERIFY(render.texcoords[render.cornerRenderVertices[0]] == glm::vec2(0.0f));
        QVERIFY(render.texcoords[render.cornerRenderVertices[1]] == glm::vec2(1.0f));
    }

    void clustersAreCompact() {
        const RenderMesh render = buildRenderMesh(makeHighPolySphere(2.5f));
        QCOMPARE(render.clusters.size(), std::size_t{129});
        for (const Cluster& cluster : render.clusters) {
            QVERIFY(cluster.bounds.diagonal() < 1.7f);  // a 129th of the surface of a sphere of 2.5
        }
    }
};

HITSCOPE_TEST(RenderMeshTest, QCoreApplication)

}  // namespace hitscope::mesh_render_test

#include "mesh_render_test.moc"
