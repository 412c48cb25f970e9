// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/coarse_triangles.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/geodesic_sphere.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "session/prepared_mesh.h"
#include "support/test_program.h"

namespace hitscope::coarse_triangles_test {

namespace {

double areaOf(const RenderMesh& mesh, std::span<const std::uint32_t> triangles) {
    double area = 0.0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const glm::dvec3 a(mesh.vertices[triangles[i]].position);
        const glm::dvec3 b(mesh.vertices[triangles[i + 1]].position);
        const glm::dvec3 c(mesh.vertices[triangles[i + 2]].position);
        area += glm::length(glm::cross(b - a, c - a)) / 2.0;
    }
    return area;
}

}  // namespace

class CoarseTrianglesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void smallMeshesHaveNone();
    void sphereKeepsItsShape();
    void facesLookTheRightWay();
    void flatPlacesStayFine_data();
    void flatPlacesStayFine();
    void manyTrianglesKeepTheShape();
    void neighboursOfOtherDrawsStayApart();
    void drawsKeepTheirShares();
    void preparedMeshesHaveThem();
};

void CoarseTrianglesTest::smallMeshesHaveNone() {
    RenderMesh mesh = buildRenderMesh(makeCube(10, 1.0f));  // 1,200 triangles
    addCoarseTriangles(mesh, 601);
    QVERIFY(mesh.coarseTriangles.empty());
    QVERIFY(mesh.coarseDraws.empty());
    addCoarseTriangles(mesh, 600);
    QVERIFY(!mesh.coarseTriangles.empty());
}

void CoarseTrianglesTest::sphereKeepsItsShape() {
    RenderMesh mesh = buildRenderMesh(makeGeodesicSphere(32, 2.0f));
    const RawVector<std::uint32_t> all = mesh.triangles;
    addCoarseTriangles(mesh, 4'000);
    const std::size_t triangles = mesh.coarseTriangles.size() / 3;
    QVERIFY2(triangles > 2'500 && triangles <= 4'000, qPrintable(QString::number(triangles)));
    QCOMPARE(mesh.triangles, all);
    QVERIFY(std::all_of(mesh.coarseTriangles.begin(), mesh.coarseTriangles.end(),
                        [&mesh](std::uint32_t vertex) { return vertex < mesh.drawnVertices; }));
    const double part = areaOf(mesh, mesh.coarseTriangles) / areaOf(mesh, mesh.triangles);
    QVERIFY2(part > 0.97 && part < 1.03, qPrintable(QString::number(part)));
}

/// Each triangle shows its front where the normals of its corners point to: it is dark where it does not.
void CoarseTrianglesTest::facesLookTheRightWay() {
    MeshData ball = makeGeodesicSphere(64, 2.0f);
    for (glm::vec3& position : ball.positions) {
        position *= 1.0f + 0.04f * std::sin(8.0f * position.x) * std::sin(8.0f * position.y);
    }
    RenderMesh mesh = buildRenderMesh(ball);
    addCoarseTriangles(mesh, 6'000);
    const auto wrong = [&mesh](std::span<const std::uint32_t> triangles) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const auto& a = mesh.vertices[triangles[i]];
            const auto& b = mesh.vertices[triangles[i + 1]];
            const auto& c = mesh.vertices[triangles[i + 2]];
            const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
            const float cosine = glm::dot(across, a.normal + b.normal + c.normal) / glm::length(across);
            count += cosine < -0.1f ? 1 : 0;  // some stand on edge
        }
        return count;
    };
    QCOMPARE(wrong(mesh.triangles), std::size_t{0});
    QVERIFY2(wrong(mesh.coarseTriangles) < 5, qPrintable(QString::number(wrong(mesh.coarseTriangles))));
}

/// No cell of a flat square is much larger than the others: a dent in it shows wherever it is.
void CoarseTrianglesTest::flatPlacesStayFine_data() {
    QTest::addColumn<int>("side");
    QTest::addColumn<int>("wanted");
    QTest::newRow("all vertices") << 200 << 8'000;
    QTest::newRow("two taken for one") << 400 << 8'000;
    QTest::newRow("sixteen taken for one") << 600 << 2'000;
}

void CoarseTrianglesTest::flatPlacesStayFine() {
    QFETCH(const int, side);
    QFETCH(const int, wanted);
    RenderMesh mesh = buildRenderMesh(makeSheet(side, side, 1.0f, 1.0f));
    addCoarseTriangles(mesh, static_cast<std::size_t>(wanted));
    QVERIFY(3 * wanted / 2 < static_cast<int>(mesh.coarseTriangles.size()));
    double largest = 0.0;
    for (std::size_t i = 0; i < mesh.coarseTriangles.size(); i += 3) {
        for (const std::size_t k : {0, 1, 2}) {
            const glm::vec3& a = mesh.vertices[mesh.coarseTriangles[i + k]].position;
            const glm::vec3& b = mesh.vertices[mesh.coarseTriangles[i + (k + 1) % 3]].position;
            largest = std::max(largest, static_cast<double>(glm::distance(a, b)));
        }
    }
    const double usual = std::sqrt(2.0 / wanted);  // the short sides of triangles that are all alike
    QVERIFY2(largest < 4.0 * usual, qPrintable(QString::number(largest / usual)));
}

/// Some vertices are taken for one before.
void CoarseTrianglesTest::manyTrianglesKeepTheShape() {
    RenderMesh mesh = buildRenderMesh(makeGeodesicSphere(120, 2.0f));  // 288,000 triangles
    addCoarseTriangles(mesh, 2'000);
    const std::size_t triangles = mesh.coarseTriangles.size() / 3;
    QVERIFY2(triangles > 1'000 && triangles <= 2'000, qPrintable(QString::number(triangles)));
    const double part = areaOf(mesh, mesh.coarseTriangles) / areaOf(mesh, mesh.triangles);
    QVERIFY2(part > 0.95 && part < 1.03, qPrintable(QString::number(part)));
}

void CoarseTrianglesTest::neighboursOfOtherDrawsStayApart() {
    MeshData sheet = makeSheet(600, 600, 1.0f, 1.0f);
    sheet.materials.resize(2);
    sheet.faceMaterials.assign(sheet.faceCount(), 0);
    for (std::size_t face = 0; face < sheet.faceCount(); ++face) {
        sheet.faceMaterials[face] = face % 3 == 0 ? 1 : 0;
    }
    sheet.texcoords = {{0.0f, 0.0f}, {1.0f, 1.0f}};  // so that no vertex is of both draws
    sheet.cornerTexcoords.resize(sheet.cornerVertices.size());
    for (std::size_t face = 0; face < sheet.faceCount(); ++face) {
        for (std::uint32_t corner = sheet.faceStarts[face]; corner < sheet.faceStarts[face + 1]; ++corner) {
            sheet.cornerTexcoords[corner] = sheet.faceMaterials[face];
        }
    }
    RenderMesh mesh = buildRenderMesh(sheet);
    addCoarseTriangles(mesh, 4'000);
    QCOMPARE(mesh.coarseDraws.size(), std::size_t{2});
    for (const DrawRange& draw : mesh.coarseDraws) {
        QVERIFY(draw.count > 0);
        for (std::uint32_t k = draw.first; k < draw.first + draw.count; ++k) {
            QCOMPARE(mesh.texcoords[mesh.coarseTriangles[k]].x, static_cast<float>(draw.material));
        }
    }
}

void CoarseTrianglesTest::drawsKeepTheirShares() {
    MeshData sphere = makeGeodesicSphere(32, 2.0f);
    sphere.materials.resize(3);
    sphere.faceMaterials.assign(sphere.faceCount(), 0);
    for (std::size_t face = 0; face < sphere.faceCount(); ++face) {
        const glm::vec3& corner = sphere.positions[sphere.face(face).front()];
        sphere.faceMaterials[face] = corner.y > 0.0f ? 1 : 0;
    }
    for (std::size_t face = 0; face < 30; ++face) {
        sphere.faceMaterials[face] = 2;  // so few that they all stay
    }
    RenderMesh mesh = buildRenderMesh(sphere);
    addCoarseTriangles(mesh, 6'000);
    QCOMPARE(mesh.coarseDraws.size(), mesh.draws.size());
    std::uint32_t behind = 0;
    for (std::size_t i = 0; i < mesh.draws.size(); ++i) {
        const DrawRange& draw = mesh.coarseDraws[i];
        QCOMPARE(draw.material, mesh.draws[i].material);
        QCOMPARE(draw.first, behind);
        behind += draw.count;
        const bool isSmall = mesh.draws[i].material == 2;
        QVERIFY(isSmall ? draw.count == mesh.draws[i].count : draw.count < mesh.draws[i].count / 3);
        QVERIFY(draw.count > 0);
        for (std::uint32_t k = draw.first; k < draw.first + draw.count && !isSmall; ++k) {
            const float y = mesh.vertices[mesh.coarseTriangles[k]].position.y;
            QVERIFY(draw.material == 1 ? y > -0.1f : y < 0.1f);
        }
    }
    QCOMPARE(std::size_t{behind}, mesh.coarseTriangles.size());
}

void CoarseTrianglesTest::preparedMeshesHaveThem() {
    const PreparedMesh prepared = prepareMesh(makeGeodesicSphere(84, 2.0f));
    const std::size_t triangles = prepared.render->coarseTriangles.size() / 3;
    QVERIFY2(triangles > kCoarseTriangles / 2 && triangles <= kCoarseTriangles,
             qPrintable(QString::number(triangles)));
}

HITSCOPE_TEST(CoarseTrianglesTest, QCoreApplication)

}  // namespace hitscope::coarse_triangles_test

#include "coarse_triangles_test.moc"
