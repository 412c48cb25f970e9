// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/refine.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "mesh/primitives.h"
#include "mesh/same_bits.h"
#include "mesh/surface/surface_measurer.h"
#include "mesh/surface/surface_topology.h"
#include "mesh/teapot.h"
#include "mesh/triangulate.h"
#include "mesh_refine_support.h"
#include "support/test_program.h"

namespace hitscope::mesh_refine_test {

using namespace refine_test;

class MeshRefineTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void keepsWhatThereWas_data();
    void keepsWhatThereWas();
    void midpointKeepsAreaAndVolume();
    void cutsTrianglesWithTwoCornersAtOnePlace();
    void triangleBecomesFour();
    void quadsStayQuads();
    void refinesOnlyWhereHitsAre();
    void refinesAroundSelectedVertices();
    void seamsStayClosed();
    void attributesGoAlong();
    void nonManifoldEdgesAreCutOnce();
    void polygonsBesideTakeVerticesIn();
    void fileCoordinatesGoAlong();
    void refusesWhatIsTooMuch();
    void canBeGivenUp();
    void isTheSameEachTime();
};

void MeshRefineTest::keepsWhatThereWas_data() {
    QTest::addColumn<MeshData>("mesh");
    QTest::addColumn<float>("length");
    QTest::addRow("tetrahedron") << tetrahedron() << 0.3f;
    QTest::addRow("torus") << torus(12, 8, 2.0, 0.7) << 0.5f;
    QTest::addRow("torus of separate corners") << exploded(torus(9, 7, 2.0, 0.7)) << 0.5f;
    QTest::addRow("open cylinder") << cylinder(12, false) << 0.2f;
    QTest::addRow("cylinder with lids of twelve corners") << cylinder(12, true) << 0.2f;
    QTest::addRow("fan of three at one edge") << nonManifoldFan(3) << 0.2f;
    QTest::addRow("torus and a loose fan") << together(torus(9, 7, 2.0, 0.7), nonManifoldFan(5)) << 0.4f;
    QTest::addRow("cube") << makeCube(3, 1.0f) << 0.3f;
    QTest::addRow("sphere with a seam") << makeUvSphere(10, 7, 1.0f) << 0.25f;
    QTest::addRow("concave polygon") << polygon({{0, 0}, {3, 0}, {3, 3}, {1.5, 0.5}, {0, 3}}) << 0.4f;
}

void MeshRefineTest::keepsWhatThereWas() {
    QFETCH(const MeshData, mesh);
    QFETCH(const float, length);
    for (const RefineMethod method : kMethods) {
        for (const bool keepQuads : {false, true}) {
            const RefinedMesh whole = refined(mesh, options(method, length, keepQuads));
            checkKept(mesh, whole);
            if (QTest::currentTestFailed()) {
                return;
            }
            QVERIFY(whole.mesh.vertexCount() > mesh.vertexCount());
            QVERIFY2(longestEdge(whole.mesh) <= static_cast<double>(length) * 1.0001, "too long");
            RefineOptions part = options(method, length, keepQuads);
            part.region = ballAt(mesh.positions[1], 0.5f);
            checkKept(mesh, refined(mesh, part));
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }
}

void MeshRefineTest::midpointKeepsAreaAndVolume() {
    for (const MeshData& mesh : {tetrahedron(), torus(12, 8, 2.0, 0.7), cylinder(12, true)}) {
        for (const RefineMethod method : {RefineMethod::Midpoint, RefineMethod::LongestEdge}) {
            const MeshData fine = refined(mesh, options(method, 0.21f)).mesh;
            QVERIFY(std::abs(area(fine) / area(mesh) - 1.0) < 1e-6);
            QVERIFY(std::abs(volume(fine) / volume(mesh) - 1.0) < 1e-6);
        }
    }
    // A cube's quads are flat: as quads they have the same area and volume too.
    const MeshData cube = makeCube(2, 1.0f);
    const MeshData fine = refined(cube, options(RefineMethod::Midpoint, 0.3f, true)).mesh;
    QVERIFY(std::abs(area(fine) - 24.0) < 1e-5 && std::abs(volume(fine) - 8.0) < 1e-5);
}

void MeshRefineTest::cutsTrianglesWithTwoCornersAtOnePlace() {
    MeshData sheet =
        meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 4, 2}});
    for (const RefineMethod method : kMethods) {
        QVERIFY(longestEdge(refined(sheet, options(method, 0.1f)).mesh) <= 0.1 * 1.0001);
    }
    // Alone, too, and with all three at one place.
    const MeshData alone =
        meshOf({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {0, 3, 4}});
    QVERIFY(longestEdge(refined(alone, options(RefineMethod::LongestEdge, 0.1f)).mesh) <= 0.1 * 1.0001);
}

void MeshRefineTest::triangleBecomesFour() {
    const MeshData one = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const RefinedMesh made = refined(one, options(RefineMethod::Midpoint, 0.8f));
    QCOMPARE(made.mesh.vertexCount(), std::size_t(6));
    QCOMPARE(made.mesh.faceCount(), std::size_t(4));
    QCOMPARE(made.mesh.positions[3], glm::vec3(0.5f, 0.0f, 0.0f));
    QCOMPARE(made.parents[0][0], 0U);
    QCOMPARE(made.parents[0][1], 1U);
    QCOMPARE(made.parents[0][2], kNoIndex);
}

void MeshRefineTest::quadsStayQuads() {
    for (const MeshData& mesh : {makeCube(2, 1.0f), torus(12, 8, 2.0, 0.7), cylinder(16, false)}) {
        const MeshData fine = refined(mesh, options(RefineMethod::Midpoint, 0.23f, true)).mesh;
        const SurfaceStatistics statistics = statisticsOf(fine);
        QCOMPARE(statistics.quads, fine.faceCount());
        QVERIFY(fine.faceCount() > 4 * mesh.faceCount());
    }
    const MeshData cut = refined(makeCube(2, 1.0f), options(RefineMethod::Midpoint, 0.3f)).mesh;
    QCOMPARE(statisticsOf(cut).triangles, cut.faceCount());
}

void MeshRefineTest::refinesOnlyWhereHitsAre() {
    const MeshData cube = makeCube(8, 2.5f);
    RefineOptions how = options(RefineMethod::Midpoint, 0.05f, true);
    how.region = ballAt({2.5f, 0.1f, 0.1f}, 0.4f);
    const MeshData fine = refined(cube, how).mesh;
    std::size_t near = 0;
    for (std::size_t v = cube.vertexCount(); v < fine.vertexCount(); ++v) {
        QVERIFY(glm::distance(fine.positions[v], {2.5f, 0.1f, 0.1f}) < 1.5f);
    }
    for (const glm::vec3& position : fine.positions) {
        near += glm::distance(position, {2.5f, 0.1f, 0.1f}) <= 0.4f ? 1 : 0;
    }
    QVERIFY2(near > 150, qPrintable(QString::number(near)));
    // Where no hit is, nothing changes: the first faces are those of another side.
    QVERIFY(fine.faceCount() < 4000);
    // A face that a small ball touches in its middle, far from all vertices, is refined.
    const MeshData one = meshOf({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, {{0, 1, 2}});
    how = options(RefineMethod::LongestEdge, 0.02f);
    how.region = ballAt({30.0f, 30.0f, 0.0f}, 0.1f);
    const MeshData small = refined(one, how).mesh;
    QVERIFY(small.vertexCount() > 100 && small.vertexCount() < 2000);
}

void MeshRefineTest::refinesAroundSelectedVertices() {
    const MeshData sheet = makeCube(8, 2.5f);
    RefineOptions how = options(RefineMethod::Midpoint, 0.1f);
    how.region = {MeshRegion::Kind::Vertices, {4, 70, 1'000'000}, {}};
    const RefinedMesh made = refined(sheet, how);
    checkKept(sheet, made);
    for (std::size_t v = made.firstNew; v < made.mesh.vertexCount(); ++v) {
        const glm::vec3& at = made.mesh.positions[v];
        QVERIFY(glm::distance(at, sheet.positions[4]) < 1.8f ||
                glm::distance(at, sheet.positions[70]) < 1.8f);
    }
    how.region.vertices.clear();
    QCOMPARE(refined(sheet, how).mesh.faceCount(), sheet.faceCount());
}

/// Two triangles with vertices of their own at the same places: what is new on their edge is at one place
/// too.
void MeshRefineTest::seamsStayClosed() {
    const MeshData split = exploded(triangulated(makeUvSphere(9, 6, 1.0f)));
    for (const RefineMethod method : kMethods) {
        const RefinedMesh made = refined(split, options(method, 0.3f));
        const SurfaceStatistics statistics = statisticsOf(made.mesh);
        QVERIFY(statistics.watertight);
        QVERIFY(statistics.places < made.mesh.vertexCount());
        // As many places as the same mesh without seams has.
        const RefinedMesh whole = refined(triangulated(makeUvSphere(9, 6, 1.0f)), options(method, 0.3f));
        QCOMPARE(statistics.places, whole.mesh.vertexCount());
    }
}

void MeshRefineTest::attributesGoAlong() {
    MeshData mesh = makeCube(2, 1.0f);
    mesh.materials.resize(2);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        mesh.faceMaterials.push_back(f < 8 ? 0 : 1);
        mesh.faceSmoothing.push_back(static_cast<std::uint32_t>(f / 4));
    }
    mesh.colours.assign(mesh.vertexCount(), glm::vec3(0.25f));
    mesh.groups = {{FaceGroup::Kind::Object, "left", 0}, {FaceGroup::Kind::Group, "right", 8}};
    const MeshData fine = refined(mesh, options(RefineMethod::Midpoint, 0.4f, true)).mesh;
    QVERIFY(validate(fine).ok());
    QCOMPARE(fine.faceMaterials.size(), fine.faceCount());
    QCOMPARE(fine.groups[1].firstFace, static_cast<std::uint32_t>(fine.faceCount() / 3));
    for (std::size_t f = 0; f < fine.faceCount(); ++f) {
        QCOMPARE(fine.faceMaterials[f], f < fine.groups[1].firstFace ? 0U : 1U);
        const glm::dvec3 across = doubleAreaVector(fine.positions, fine.face(f));
        for (std::uint32_t c = fine.faceStarts[f]; c < fine.faceStarts[f + 1]; ++c) {
            QVERIFY(fine.cornerNormals[c] != kNoIndex && fine.cornerTexcoords[c] != kNoIndex);
            const glm::dvec3 normal(fine.normals[fine.cornerNormals[c]]);
            QVERIFY(glm::dot(normal, glm::normalize(across)) > 0.999);
        }
    }
    for (const glm::vec3& colour : fine.colours) {
        QCOMPARE(colour, glm::vec3(0.25f));
    }
    // A cube's side has texture coordinates [0, 1]^2: every quad its share of that.
    double covered = 0.0;
    for (std::size_t f = 0; f < fine.faceCount(); ++f) {
        for (std::uint32_t c = fine.faceStarts[f]; c < fine.faceStarts[f + 1]; ++c) {
            const std::uint32_t next = c + 1 < fine.faceStarts[f + 1] ? c + 1 : fine.faceStarts[f];
            const glm::dvec2 a(fine.texcoords[fine.cornerTexcoords[c]]);
            const glm::dvec2 b(fine.texcoords[fine.cornerTexcoords[next]]);
            covered += 0.5 * (a.x * b.y - a.y * b.x);
        }
    }
    QVERIFY(std::abs(std::abs(covered) - 6.0) < 1e-5);
}

void MeshRefineTest::nonManifoldEdgesAreCutOnce() {
    const MeshData fan = nonManifoldFan(5);
    for (const RefineMethod method : kMethods) {
        const MeshData fine = refined(fan, options(method, 0.26f)).mesh;
        std::size_t on = 0;
        for (const glm::vec3& p : fine.positions) {
            on += p.x == 0.0f && p.y == 0.0f ? 1 : 0;
        }
        // Midpoints: 0, 1/4, 1/2, 3/4, 1. The butterfly scheme goes on until the longest edge is short too.
        QVERIFY(on == 5 || (method == RefineMethod::Butterfly && on == 9));
        QCOMPARE(statisticsOf(fine).nonManifoldEdges, on - 1);
    }
}

void MeshRefineTest::polygonsBesideTakeVerticesIn() {
    const MeshData lids = cylinder(12, true);
    RefineOptions how = options(RefineMethod::Midpoint, 0.3f);
    how.region = ballAt({1.0f, 0.0f, 0.5f}, 0.05f);
    const RefinedMesh made = refined(lids, how);
    checkKept(lids, made);
    QVERIFY(statisticsOf(made.mesh).largerPolygons == 2);
}

void MeshRefineTest::fileCoordinatesGoAlong() {
    MeshData mesh = makeCube(2, 1.0f);
    for (glm::vec3& position : mesh.positions) {
        position = 7.0f * position + glm::vec3(1000.0f, 0.0f, 0.0f);
    }
    place(mesh, 5.0f);
    const MeshData before = mesh;
    const MeshData fine = refined(mesh, options(RefineMethod::Midpoint, 0.7f)).mesh;
    QVERIFY(validate(fine).ok());
    for (std::size_t v = 0; v < fine.vertexCount(); ++v) {
        const glm::dvec3 local = (fine.filePositions[v] - fine.placement.centre) * fine.placement.scale;
        QVERIFY(glm::distance(local, glm::dvec3(fine.positions[v])) < 1e-9 || v < before.vertexCount());
        QVERIFY(v >= before.vertexCount() || fine.filePositions[v] == before.filePositions[v]);
    }
}

void MeshRefineTest::refusesWhatIsTooMuch() {
    const MeshData cube = makeCube(8, 2.5f);
    for (const float length : {0.0f, -1.0f, std::nanf("")}) {
        QVERIFY(!refine(cube, options(RefineMethod::Midpoint, length)).ok());
    }
    for (const RefineMethod method : kMethods) {
        QVERIFY(!refine(cube, options(method, 1e-6f)).ok());
        const Result<RefinedMesh> few = refine(cube, options(method, 0.1f), {}, 5000);
        QVERIFY(!few.ok());
        QVERIFY(QString::fromStdString(few.error().what).contains(QStringLiteral("5000 faces")));
    }
    // As short as floats can tell apart it ends as well.
    const MeshData tiny = meshOf({{1, 1, 1}, {1.000001f, 1, 1}, {1, 1.000001f, 1}}, {{0, 1, 2}});
    QVERIFY(refine(tiny, options(RefineMethod::Midpoint, 1e-9f)).ok());
}

void MeshRefineTest::canBeGivenUp() {
    int calls = 0;
    double last = 0.0;
    const auto goOn = [&](double done) {
        last = done;
        return ++calls < 2;
    };
    QVERIFY(!refine(makeCube(4, 2.5f), options(RefineMethod::Midpoint, 0.05f), goOn).ok());
    QCOMPARE(calls, 2);
    QVERIFY(last > 0.0 && last <= 1.0);
}

void MeshRefineTest::isTheSameEachTime() {
    for (const RefineMethod method : kMethods) {
        const MeshData one = refined(makeTeapot(), options(method, 0.4f)).mesh;
        const MeshData other = refined(makeTeapot(), options(method, 0.4f)).mesh;
        QVERIFY(one.positions == other.positions && one.cornerVertices == other.cornerVertices);
    }
}

HITSCOPE_TEST(MeshRefineTest, QCoreApplication)

}  // namespace hitscope::mesh_refine_test

#include "mesh_refine_test.moc"
