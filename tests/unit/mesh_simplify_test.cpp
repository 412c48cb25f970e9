// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/simplify.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh/primitives.h"
#include "mesh/refine/moved_shape.h"
#include "mesh/refine/smooth.h"
#include "mesh/same_bits.h"
#include "mesh/surface/surface_topology.h"
#include "solids.h"
#include "support/test_program.h"

namespace hitscope::mesh_simplify_test {

using namespace test;

namespace {

MeshData simplified(const MeshData& mesh, const SimplifyOptions& how) {
    Result<MeshData> result = simplify(mesh, how);
    if (!result) {
        qWarning("%s", result.error().message().c_str());
        return {};
    }
    return std::move(result).value();
}

MeshData smoothed(const MeshData& mesh, const SmoothOptions& how) {
    Result<MeshData> result = smooth(mesh, how);
    if (!result) {
        qWarning("%s", result.error().message().c_str());
        return {};
    }
    return std::move(result).value();
}

SurfaceStatistics surfaceOf(const MeshData& mesh) {
    return SurfaceTopology::build(mesh)->statistics();
}

std::size_t trianglesOf(const MeshData& mesh) {
    return mesh.cornerVertices.size() - 2 * mesh.faceCount();
}

}  // namespace

class MeshSimplifyTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void keepsAShareOfTheTriangles();
    void keepsTheTopology();
    void flatSidesLoseVerticesFirst();
    void leavesWhatIsOutsideTheRegion();
    void keepsSeamsAndMaterials_data();
    void keepsSeamsAndMaterials();
    void keepsASeamInAPlane();
    void keepsWhereASeamEnds();
    void refusesSharesThatMeanNothing();
    void smoothingEvensASpikeOut();
    void smoothingLeavesOthersInEveryBit();
    void smoothingKeepsBordersAndSeams();
    void otherShapesLoseTheirNormals();
};

void MeshSimplifyTest::keepsAShareOfTheTriangles() {
    const MeshData mesh = torus(40, 24, 2.0, 0.7);
    for (const float share : {0.75f, 0.5f, 0.2f}) {
        const MeshData made = simplified(mesh, {.share = share, .region = {}});
        QVERIFY2(validate(made).ok(), "valid");
        const double left = static_cast<double>(trianglesOf(made)) / static_cast<double>(trianglesOf(mesh));
        QVERIFY2(std::abs(left - static_cast<double>(share)) < 0.01, qPrintable(QString::number(left)));
        for (std::size_t v = 0; v < made.vertexCount(); ++v) {
            QVERIFY(sameBits(made.positions[v], mesh.positions[made.sourceVertices[v]]));
            QVERIFY(v == 0 || made.sourceVertices[v - 1] < made.sourceVertices[v]);
        }
    }
}

void MeshSimplifyTest::keepsTheTopology() {
    for (const MeshData& mesh : {torus(24, 16, 2.0, 0.7), exploded(torus(24, 16, 2.0, 0.7)),
                                 together(torus(24, 16, 2.0, 0.7), nonManifoldFan(4)), cylinder(30, false)}) {
        const SurfaceStatistics was = surfaceOf(mesh);
        const SurfaceStatistics is = surfaceOf(simplified(mesh, {.share = 0.4f, .region = {}}));
        QCOMPARE(is.genus, was.genus);
        QCOMPARE(is.watertight, was.watertight);
        QCOMPARE(is.components, was.components);
        QCOMPARE(is.boundaryEdges, was.boundaryEdges);
        QCOMPARE(is.nonManifoldEdges, was.nonManifoldEdges);
    }
}

void MeshSimplifyTest::flatSidesLoseVerticesFirst() {
    const MeshData cube = withoutNormals(makeCube(8, 1.0f));
    MeshData bare = cube;
    bare.texcoords.clear();
    bare.cornerTexcoords.clear();
    const MeshData made = simplified(bare, {.share = 0.1f, .region = {}});
    QVERIFY(trianglesOf(made) < trianglesOf(bare) / 8);
    for (const float x : {-1.0f, 1.0f}) {
        for (const float y : {-1.0f, 1.0f}) {
            for (const float z : {-1.0f, 1.0f}) {
                QVERIFY(std::count(made.positions.begin(), made.positions.end(), glm::vec3(x, y, z)) == 1);
            }
        }
    }
}

void MeshSimplifyTest::leavesWhatIsOutsideTheRegion() {
    const MeshData mesh = torus(40, 24, 2.0, 0.7);
    SimplifyOptions how{.share = 0.3f, .region = {MeshRegion::Kind::Balls, {}, {{{2.7f, 0.0f, 0.0f}, 0.8f}}}};
    const MeshData made = simplified(mesh, how);
    QVERIFY(made.faceCount() < mesh.faceCount());
    QCOMPARE(surfaceOf(made).genus, surfaceOf(mesh).genus);
    std::vector<bool> isThere(mesh.vertexCount(), false);
    for (const std::uint32_t vertex : made.sourceVertices) {
        isThere[vertex] = true;
    }
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        QVERIFY(isThere[v] || glm::distance(mesh.positions[v], {2.7f, 0.0f, 0.0f}) < 1.2f);
    }
    QVERIFY(surfaceOf(made).quads > mesh.faceCount() / 2);
}

void MeshSimplifyTest::keepsSeamsAndMaterials_data() {
    QTest::addColumn<bool>("hasMaterials");
    QTest::addRow("seams") << false;
    QTest::addRow("seams and materials") << true;
}

/// A cube's sides have texture coordinates and materials of their own: no triangle goes round an edge.
void MeshSimplifyTest::keepsSeamsAndMaterials() {
    QFETCH(const bool, hasMaterials);
    MeshData cube = makeCube(6, 1.0f);
    cube.materials.resize(6);
    for (std::size_t f = 0; hasMaterials && f < cube.faceCount(); ++f) {
        cube.faceMaterials.push_back(static_cast<std::uint32_t>(6 * f / cube.faceCount()));
    }
    const MeshData made = simplified(cube, {.share = 0.2f, .region = {}});
    QVERIFY(validate(made).ok());
    QVERIFY(made.faceCount() > 11 && made.faceCount() < cube.faceCount());
    double covered = 0.0;
    for (std::size_t f = 0; f < made.faceCount(); ++f) {
        const glm::vec3& first = made.normals[made.cornerNormals[made.faceStarts[f]]];
        for (std::uint32_t c = made.faceStarts[f]; c < made.faceStarts[f + 1]; ++c) {
            const std::uint32_t next = c + 1 < made.faceStarts[f + 1] ? c + 1 : made.faceStarts[f];
            QVERIFY(made.normals[made.cornerNormals[c]] == first);
            const glm::dvec2 a(made.texcoords[made.cornerTexcoords[c]]);
            const glm::dvec2 b(made.texcoords[made.cornerTexcoords[next]]);
            covered += 0.5 * (a.x * b.y - a.y * b.x);
        }
    }
    QVERIFY2(std::abs(std::abs(covered) - 6.0) < 1e-5, qPrintable(QString::number(covered)));
}

/// Only the texture coordinates tell the two halves of a flat sheet apart: no triangle has corners of both.
void MeshSimplifyTest::keepsASeamInAPlane() {
    constexpr int kCells = 12;
    constexpr float kApart = 10.0f;  // between the halves' texture coordinates, which are else x and y
    MeshData sheet;
    sheet.faceStarts.assign(1, 0);
    for (int y = 0; y <= kCells; ++y) {
        for (int x = 0; x <= kCells; ++x) {
            sheet.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0f);
        }
    }
    const auto count = static_cast<std::uint32_t>(sheet.positions.size());
    for (const float aside : {0.0f, kApart}) {
        for (const glm::vec3& position : sheet.positions) {
            sheet.texcoords.emplace_back(position.x + aside, position.y);
        }
    }
    for (int y = 0; y < kCells; ++y) {
        for (int x = 0; x < kCells; ++x) {
            const auto at = [](int column, int row) {
                return static_cast<std::uint32_t>(row * (kCells + 1) + column);
            };
            for (const std::uint32_t vertex : {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)}) {
                sheet.cornerVertices.push_back(vertex);
                const bool isRight = x >= kCells / 2;
                sheet.cornerTexcoords.push_back(vertex + (isRight ? count : 0u));
            }
            sheet.faceStarts.push_back(static_cast<std::uint32_t>(sheet.cornerVertices.size()));
        }
    }
    const MeshData made = simplified(sheet, {.share = 0.1f, .region = {}});
    QVERIFY(validate(made).ok());
    QVERIFY(trianglesOf(made) < trianglesOf(sheet) / 4);
    for (std::size_t f = 0; f < made.faceCount(); ++f) {
        std::array<bool, 2> has{};
        for (std::uint32_t c = made.faceStarts[f]; c < made.faceStarts[f + 1]; ++c) {
            const glm::vec2 texcoord(made.texcoords[made.cornerTexcoords[c]]);
            const glm::vec3& position = made.positions[made.cornerVertices[c]];
            const bool isRight = texcoord.x - position.x > kApart / 2.0f;
            has[isRight ? 1 : 0] = true;
            QVERIFY(texcoord == glm::vec2(position.x + (isRight ? kApart : 0.0f), position.y));
        }
        QVERIFY(has[0] != has[1]);
    }
}

/// Texture coordinates go round the middle, from where a seam runs to the right: there they are 0 above it
/// and the distance to the middle below.
void MeshSimplifyTest::keepsWhereASeamEnds() {
    constexpr int kHalf = 6;
    const auto roundAt = [](const glm::vec3& at, bool isBelow) {
        const double angle = std::atan2(static_cast<double>(at.y), static_cast<double>(at.x));
        const double turns = angle / (2.0 * std::numbers::pi) + (angle < 0.0 || isBelow ? 1.0 : 0.0);
        const float radius = glm::length(at);
        return glm::vec2(radius * static_cast<float>(turns), radius);
    };
    const auto isOnSeam = [](const glm::vec3& at) { return at.y == 0.0f && at.x >= 0.0f; };
    MeshData sheet;
    sheet.faceStarts.assign(1, 0);
    for (int y = -kHalf; y <= kHalf; ++y) {
        for (int x = -kHalf; x <= kHalf; ++x) {
            sheet.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0f);
        }
    }
    for (const bool isBelow : {false, true}) {
        for (const glm::vec3& at : sheet.positions) {
            sheet.texcoords.push_back(roundAt(at, isBelow && isOnSeam(at)));
        }
    }
    constexpr int kRow = 2 * kHalf + 1;
    for (int y = 0; y < 2 * kHalf; ++y) {
        for (int x = 0; x < 2 * kHalf; ++x) {
            for (const int vertex :
                 {y * kRow + x, y * kRow + x + 1, (y + 1) * kRow + x + 1, (y + 1) * kRow + x}) {
                sheet.cornerVertices.push_back(static_cast<std::uint32_t>(vertex));
                sheet.cornerTexcoords.push_back(
                    static_cast<std::uint32_t>(vertex + (y < kHalf ? kRow * kRow : 0)));
            }
            sheet.faceStarts.push_back(static_cast<std::uint32_t>(sheet.cornerVertices.size()));
        }
    }
    const MeshData made = simplified(sheet, {.share = 0.1f, .region = {}});
    QVERIFY(trianglesOf(made) < trianglesOf(sheet) / 3);
    for (std::size_t f = 0; f < made.faceCount(); ++f) {
        glm::vec3 middle(0.0f);
        for (const std::uint32_t vertex : made.face(f)) {
            middle += made.positions[vertex];
        }
        for (std::uint32_t c = made.faceStarts[f]; c < made.faceStarts[f + 1]; ++c) {
            const glm::vec3& at = made.positions[made.cornerVertices[c]];
            const glm::vec2 expected = roundAt(at, isOnSeam(at) && middle.y < 0.0f);
            QVERIFY(glm::distance(made.texcoords[made.cornerTexcoords[c]], expected) < 1.0e-5f);
        }
    }
}

void MeshSimplifyTest::refusesSharesThatMeanNothing() {
    for (const float share : {0.0f, 1.0f, -0.5f, std::nanf("")}) {
        QVERIFY(!simplify(makeCube(2, 1.0f), {.share = share, .region = {}}).ok());
    }
    QVERIFY(!smooth(makeCube(2, 1.0f), {.passes = 0, .keepBorders = true, .region = {}}).ok());
}

void MeshSimplifyTest::smoothingEvensASpikeOut() {
    MeshData mesh = torus(40, 24, 2.0, 0.7);
    mesh.positions[100] *= 1.5f;
    const float spike = glm::length(mesh.positions[100] - mesh.positions[101]);
    SmoothOptions how;
    how.region = {MeshRegion::Kind::Vertices, {100}, {}};
    const MeshData made = smoothed(mesh, how);
    QVERIFY(glm::length(made.positions[100] - made.positions[101]) < 0.5f * spike);
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        QCOMPARE(sameBits(made.positions[v], mesh.positions[v]), v != 100);
    }
    QCOMPARE(made.cornerVertices, mesh.cornerVertices);
    QVERIFY(!made.isAsRead());
}

void MeshSimplifyTest::smoothingLeavesOthersInEveryBit() {
    const MeshData fan = together(nonManifoldFan(4), torus(12, 8, 2.0, 0.7));
    const MeshData made = smoothed(fan, {});
    for (std::size_t v = 0; v < 6; ++v) {
        QVERIFY(sameBits(made.positions[v], fan.positions[v]));
    }
    QVERIFY(!sameBits(made.positions[10], fan.positions[10]));
}

void MeshSimplifyTest::smoothingKeepsBordersAndSeams() {
    const MeshData tube = cylinder(12, false);
    QVERIFY(smoothed(tube, {}).positions == tube.positions);
    SmoothOptions loose;
    loose.keepBorders = false;
    const MeshData made = smoothed(tube, loose);
    QVERIFY(glm::length(glm::vec2(made.positions[0])) < 0.9f);
    QCOMPARE(made.positions[0].z, 0.0f);
    const MeshData split = smoothed(exploded(torus(12, 8, 2.0, 0.7)), {});
    QVERIFY(surfaceOf(split).watertight);
}

void MeshSimplifyTest::otherShapesLoseTheirNormals() {
    const MeshData cube = makeCube(4, 1.0f);
    PageVector<glm::vec3> positions = cube.positions;
    positions[20] += glm::vec3(0.1f);
    const MeshData moved = withShape(cube, positions);
    QVERIFY(validate(moved).ok());
    for (std::size_t f = 0; f < cube.faceCount(); ++f) {
        const auto face = cube.face(f);
        const bool touches = std::find(face.begin(), face.end(), 20U) != face.end();
        for (std::uint32_t c = cube.faceStarts[f]; c < cube.faceStarts[f + 1]; ++c) {
            QCOMPARE(moved.cornerNormals[c], touches ? kNoIndex : cube.cornerNormals[c]);
        }
    }
}

HITSCOPE_TEST(MeshSimplifyTest, QCoreApplication)

}  // namespace hitscope::mesh_simplify_test

#include "mesh_simplify_test.moc"
