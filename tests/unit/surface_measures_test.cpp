// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_measurer.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "mesh/primitives.h"
#include "mesh/surface/face_measure.h"
#include "solids.h"
#include "support/test_program.h"

namespace hitscope::surface_measures_test {

using namespace test;

namespace {

constexpr double kPi = std::numbers::pi;

SurfaceMeasurer measurerOf(const MeshData& mesh) {
    auto shared = std::make_shared<const MeshData>(mesh);
    auto topology = SurfaceTopology::build(*shared);
    return {std::move(shared), std::move(topology)};
}

bool near(double is, double should, double tolerance) {
    return std::abs(is - should) <= tolerance;
}

/// The same mesh with other positions, measured from scratch without any of the code under test: Heron's
/// formula, tetrahedra about the origin.
struct BruteForce {
    double area = 0.0;
    double volume = 0.0;
    glm::dvec3 moment{0.0};
    double shortest = 1e300;
    double longest = 0.0;

    BruteForce(const MeshData& mesh, std::span<const glm::vec3> positions) {
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto face = mesh.face(f);
            for (std::size_t i = 1; i + 1 < face.size(); ++i) {
                add(glm::dvec3(positions[face[0]]), glm::dvec3(positions[face[i]]),
                    glm::dvec3(positions[face[i + 1]]));
            }
            for (std::size_t i = 0; i < face.size(); ++i) {
                const double length = glm::distance(glm::dvec3(positions[face[i]]),
                                                    glm::dvec3(positions[face[(i + 1) % face.size()]]));
                shortest = std::min(shortest, length);
                longest = std::max(longest, length);
            }
        }
    }
    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const double x = glm::distance(a, b);
        const double y = glm::distance(b, c);
        const double z = glm::distance(c, a);
        const double s = 0.5 * (x + y + z);
        area += std::sqrt(std::max(0.0, s * (s - x) * (s - y) * (s - z)));
        const double part = glm::dot(a, glm::cross(b, c)) / 6.0;
        volume += part;
        moment += part * (a + b + c) / 4.0;
    }
};

/// Each polygon as its fan.
MeshData fans(const MeshData& mesh) {
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (std::size_t i = 1; i + 1 < mesh.face(f).size(); ++i) {
            faces.push_back({mesh.face(f)[0], mesh.face(f)[i], mesh.face(f)[i + 1]});
        }
    }
    return meshOf(mesh.positions, faces);
}

/// A dent of random vertices of a sphere about a point, each moved inwards.
std::vector<MovedVertex> dent(const MeshData& mesh, std::span<const glm::vec3> positions,
                              std::mt19937& random) {
    const glm::vec3 centre = positions[random() % positions.size()];
    std::vector<MovedVertex> moved;
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
        if (glm::distance(positions[v], centre) < 0.4f) {
            moved.push_back({v, positions[v] * 0.93f});
        }
    }
    return moved;
}

}  // namespace

class SurfaceMeasuresTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cube() {
        const SurfaceMeasures m = measurerOf(makeCube(8, 2.5f)).measures();
        QVERIFY(near(m.faceArea.sum, 150.0, 1e-9));
        QVERIFY(near(m.volume(), 125.0, 1e-9));
        QVERIFY(near(glm::length(m.centreOfMass()), 0.0, 1e-12));
        QCOMPARE(m.box.size(), glm::dvec3(5.0));
        QCOMPARE(m.edgeLength.count, std::size_t{768});
        QVERIFY(near(m.edgeLength.sum, 768 * 0.625, 1e-9));
        QVERIFY(near(m.edgeLength.least, 0.625, 1e-12) && near(m.edgeLength.greatest, 0.625, 1e-12));
        QVERIFY(near(m.aspect.least, 1.0, 1e-12) && near(m.aspect.greatest, 1.0, 1e-12));
        QCOMPARE(m.degenerateFaces, std::size_t{0});
        QCOMPARE(m.flippedFaces, std::size_t{0});
    }

    /// A cube with one corner pulled out: what counts is the triangles that it is drawn and exported as,
    /// which do not depend on where the file begins a face.
    void quadsAreTheTrianglesTheyAreDrawnAs() {
        PageVector<glm::vec3> corners;
        for (int i = 0; i < 8; ++i) {
            corners.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
        }
        corners[7] = glm::vec3(2.0f);
        std::vector<std::vector<std::uint32_t>> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (int turn = 0; turn < 4; ++turn) {
            const SurfaceMeasures m = measurerOf(meshOf(corners, faces)).measures();
            // Cut on the diagonals away from that corner: it adds a pyramid to each of its three faces.
            QVERIFY2(near(m.volume(), 4.0 / 3.0 + 1.0 / 6.0, 1e-12), qPrintable(QString::number(m.volume())));
            for (std::vector<std::uint32_t>& face : faces) {
                std::rotate(face.begin(), face.begin() + 1, face.end());
            }
        }
    }

    /// They stay those of the original shape, whatever moves.
    void trianglesStayAsTheyWereCut() {
        SurfaceMeasurer measurer = measurerOf(
            meshOf({{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {1.125f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}},
                   {{0, 1, 2, 3}}));
        measurer.move(std::vector<MovedVertex>{{0, {-2.0f, -2.0f, 0.0f}}, {2, {1.0f, 1.0f, 1.0f}}});
        const glm::dvec3 from(1.0, 0.0, 0.0);  // cut between corners 1 and 3
        const glm::dvec3 to(0.0, 1.0, 0.0);
        const double area = 0.5 * glm::length(glm::cross(from - glm::dvec3(-2.0, -2.0, 0.0),
                                                         to - glm::dvec3(-2.0, -2.0, 0.0))) +
                            0.5 * glm::length(glm::cross(from - glm::dvec3(1.0), to - glm::dvec3(1.0)));
        QVERIFY2(near(measurer.measures().faceArea.sum, area, 1e-12),
                 qPrintable(QString::number(measurer.measures().faceArea.sum)));
    }

    void sphereApproachesTheClosedForm() {
        const SurfaceMeasures m = measurerOf(makeHighPolySphere(1.0f)).measures();
        QVERIFY(near(m.faceArea.sum, 4.0 * kPi, 0.02));
        QVERIFY(near(m.volume(), 4.0 / 3.0 * kPi, 0.01));
    }

    void torusApproachesTheClosedForm() {
        const SurfaceMeasures m = measurerOf(torus(600, 300, 2.0, 0.5)).measures();
        QVERIFY(near(m.faceArea.sum, 4.0 * kPi * kPi * 2.0 * 0.5, 4e-3));
        QVERIFY(near(m.volume(), 2.0 * kPi * kPi * 2.0 * 0.25, 2e-3));
        QVERIFY(near(glm::length(m.centreOfMass()), 0.0, 1e-6));
    }

    void cylinderAndItsCentre() {
        MeshData mesh = cylinder(1000, true);
        for (glm::vec3& position : mesh.positions) {
            position += glm::vec3(512.0f, -256.0f, 64.0f);
        }
        const SurfaceMeasures m = measurerOf(mesh).measures();
        QVERIFY(near(m.faceArea.sum, 4.0 * kPi, 1e-3));
        QVERIFY(near(m.volume(), kPi, 1e-3));
        QVERIFY(glm::distance(m.centreOfMass(), glm::dvec3(512.0, -256.0, 64.5)) < 1e-4);
    }

    void insideOutHasTheSameVolumeAndCentre() {
        MeshData mesh = makeCube(1, 1.0f);
        for (glm::vec3& position : mesh.positions) {
            position.x += 3.0f;
        }
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            turnOver(mesh, f);
        }
        const SurfaceMeasures m = measurerOf(mesh).measures();
        QVERIFY(m.signedVolume < 0.0);
        QVERIFY(near(m.volume(), 8.0, 1e-9));
        QVERIFY(near(m.centreOfMass().x, 3.0, 1e-9));
    }

    void concavePolygonsKeepTheirArea() {
        // An arrowhead whose fan about the first corner covers part of it twice.
        const MeshData arrow = polygon({{0, 2}, {0, 0}, {-2, 0}, {0, -4}, {2, 0}});
        QCOMPARE(measurerOf(arrow).measures().faceArea.sum, 10.0);
    }

    void aspectIsOneForRegularPolygons() {
        for (std::uint32_t n = 3; n < 12; ++n) {
            std::vector<glm::vec2> outline;
            for (std::uint32_t i = 0; i < n; ++i) {
                outline.emplace_back(std::cos(2.0 * kPi * i / n), std::sin(2.0 * kPi * i / n));
            }
            QVERIFY(near(measurerOf(polygon(outline)).measures().aspect.greatest, 1.0, 1e-5));
        }
        // Verdict's: a rectangle of 2 by 1 has 2 * 6 / (4 * 2).
        QVERIFY(
            near(measurerOf(polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}})).measures().aspect.least, 1.5, 1e-12));
    }

    void degenerateFacesAreToldApart() {
        const SurfaceMeasures m = measurerOf(meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},
                                                    {{0, 1, 2}, {0, 1, 3}, {1, 1, 3}}))
                                      .measures();
        QCOMPARE(m.degenerateFaces, std::size_t{2});
        QCOMPARE(m.aspect.count, std::size_t{1});
    }

    /// Whatever was moved and moved back: the sums are those of a fresh start, bit by bit, and those of
    /// another way to compute them nearly.
    void followsMovesWithoutDrift() {
        const MeshData mesh = fans(makeHighPolySphere(2.5f));
        SurfaceMeasurer measurer = measurerOf(mesh);
        std::mt19937 random(11);
        for (int round = 0; round < 60; ++round) {
            measurer.move(dent(mesh, measurer.positions(), random));
        }
        SurfaceMeasurer fresh = measurerOf(mesh);
        std::vector<MovedVertex> all;
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            all.push_back({v, measurer.positions()[v]});
        }
        fresh.move(all);
        QVERIFY(measurer.measures() == fresh.measures());
        QVERIFY(measurer.displacements().vertices == fresh.displacements().vertices);

        const BruteForce other(mesh, measurer.positions());
        const SurfaceMeasures m = measurer.measures();
        QVERIFY(near(m.faceArea.sum, other.area, 1e-9 * other.area));
        QVERIFY(near(m.signedVolume, other.volume, 1e-9 * other.volume));
        QVERIFY(glm::distance(m.centreOfMass(), other.moment / other.volume) < 1e-9);
        QCOMPARE(m.edgeLength.least, other.shortest);
        QCOMPARE(m.edgeLength.greatest, other.longest);
        QVERIFY(m.volume() < measurer.original().volume());

        for (MovedVertex& vertex : all) {
            vertex.position = mesh.positions[vertex.vertex];
        }
        measurer.move(all);
        QVERIFY(measurer.measures() == measurer.original());
        QVERIFY(measurer.displacements().vertices.empty());
    }

    void splitVerticesMoveAsOne() {
        const MeshData mesh = exploded(makeCube(6, 1.0f));
        SurfaceMeasurer measurer = measurerOf(mesh);
        std::vector<MovedVertex> moved;
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            moved.push_back({v, mesh.positions[v] * glm::vec3(1.0f, 2.0f, 1.0f)});
        }
        measurer.move(moved);
        QVERIFY(near(measurer.measures().volume(), 16.0, 1e-9));
        QVERIFY(near(measurer.measures().edgeLength.greatest, 2.0 / 3.0, 1e-6));
        QVERIFY(near(measurer.measures().faceArea.sum, 2 * 4.0 + 4 * 8.0, 1e-5));
    }

    void displacementsInNumbers() {
        const MeshData mesh = meshOf(PageVector<glm::vec3>(6), {});
        SurfaceMeasurer measurer = measurerOf(mesh);
        measurer.move(std::vector<MovedVertex>{
            {0, {1, 0, 0}}, {1, {0, 2, 0}}, {2, {0, 0, -4}}, {3, {5, 0, 0}}, {4, {0, 0, 0}}});
        const Displacements list = measurer.displacements();
        const Displacements* lists[] = {&list};
        const Displacements::Summary s = summarise(lists);
        QCOMPARE(s.length.count, std::size_t{4});
        QCOMPARE(s.length.least, 1.0);
        QCOMPARE(s.length.greatest, 5.0);
        QCOMPARE(s.length.mean(), 3.0);
        QCOMPARE(s.median, 3.0);
        QCOMPARE(s.rootMeanSquare, std::sqrt(46.0 / 4.0));
        QCOMPARE(s.standardDeviation, std::sqrt((4.0 + 1.0 + 1.0 + 4.0) / 4.0));
        const auto within = list.within(2.0, 4.0);
        QVERIFY(std::equal(within.begin(), within.end(), std::begin({1u, 2u})));
        QCOMPARE(histogramOf(lists, 5.0, 5).counts, (std::vector<std::uint32_t>{0, 1, 1, 0, 2}));
        const Displacements* twice[] = {&list, &list};
        QCOMPARE(summarise(twice).median, 3.0);
        QCOMPARE(summarise({}).length.count, std::size_t{0});
    }

    void harmsAreListed() {
        // Three triangles: one pushed through itself, one pressed flat, one drawn out.
        const MeshData mesh = meshOf({{0, 0, 0},
                                      {1, 0, 0},
                                      {0, 1, 0},
                                      {3, 0, 0},
                                      {4, 0, 0},
                                      {3, 1, 0},
                                      {6, 0, 0},
                                      {7, 0, 0},
                                      {6, 1, 0}},
                                     {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
        SurfaceMeasurer measurer = measurerOf(mesh);
        std::size_t found = 0;
        QVERIFY(measurer.harms(2.0f, 10, found).empty());
        measurer.move(std::vector<MovedVertex>{{2, {0, -1, 0}}, {5, {3.5f, 0, 0}}, {8, {6, 2.5f, 0}}});
        const std::vector<FaceHarm> harms = measurer.harms(2.0f, 10, found);
        QCOMPARE(found, std::size_t{3});
        QVERIFY(harms[0].face == 0 && harms[0].kind == FaceHarm::Kind::Flipped);
        QVERIFY(harms[1].face == 1 && harms[1].kind == FaceHarm::Kind::Degenerated);
        QVERIFY(harms[2] == (FaceHarm{2, FaceHarm::Kind::Stretched, 2.5f}));
        QCOMPARE(measurer.measures().flippedFaces, std::size_t{1});
        QCOMPARE(measurer.measures().degenerateFaces, std::size_t{1});
        QCOMPARE(measurer.harms(2.6f, 10, found).size(), std::size_t{2});
        QCOMPARE(measurer.harms(2.0f, 1, found).size(), std::size_t{1});
        QCOMPARE(found, std::size_t{3});
    }

    /// What MeshLab 2020.09 (meshlabserver, "Compute Topological Measures" and "Compute Geometric Measures")
    /// prints for the same triangles, written to PLY with nine digits.
    void agreesWithMeshLab_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<int>("edges");
        QTest::addColumn<int>("boundary");
        QTest::addColumn<int>("holes");
        QTest::addColumn<int>("components");
        QTest::addColumn<int>("genus");
        QTest::addColumn<double>("area");
        QTest::addColumn<double>("length");
        QTest::addColumn<double>("volume");
        QTest::addRow("torus") << 0 << 2400 << 0 << 0 << 1 << 1 << 39.215340 << 657.361755 << 9.668181;
        QTest::addRow("torus with two holes")
            << 1 << 2395 << 11 << 2 << 1 << 1 << 39.002987 << 655.330200 << 0.0;
        QTest::addRow("two tori and a vertex")
            << 2 << 4800 << 0 << 0 << 2 << 2 << 78.431297 << 1314.723511 << 19.336365;
    }
    void agreesWithMeshLab() {
        QFETCH(int, which);
        MeshData mesh = fans(torus(40, 20, 2.0, 0.5));
        if (which == 1) {
            std::vector<std::vector<std::uint32_t>> faces;
            for (std::size_t f = 3; f < mesh.faceCount(); ++f) {
                if (f < 400 || f >= 404) {
                    faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
                }
            }
            mesh = meshOf(mesh.positions, faces);
        } else if (which == 2) {
            MeshData other = mesh;
            for (glm::vec3& position : other.positions) {
                position.x += 9.0f;
            }
            mesh = together(mesh, other);
            mesh.positions.emplace_back(50.0f, 0.0f, 0.0f);
        }
        const SurfaceMeasurer measurer = measurerOf(mesh);
        const SurfaceStatistics& s = measurer.topology().statistics();
        const SurfaceMeasures m = measurer.measures();
        QTEST(static_cast<int>(s.edges), "edges");
        QTEST(static_cast<int>(s.boundaryEdges), "boundary");
        QTEST(static_cast<int>(s.holes), "holes");
        QTEST(static_cast<int>(s.components), "components");
        QTEST(static_cast<int>(s.genus.value_or(-1)), "genus");
        QFETCH(double, area);
        QFETCH(double, length);
        QFETCH(double, volume);
        // MeshLab adds up in float: it prints 78.431297 for twice what it prints as 39.215340.
        QVERIFY(near(m.faceArea.sum, area, 1e-5 * area));
        QVERIFY(near(m.edgeLength.sum, length, 1e-5 * length));
        QCOMPARE(s.isSolid(), volume > 0.0);
        if (volume > 0.0) {
            QVERIFY(near(m.volume(), volume, 1e-5 * volume));
        }
        QCOMPARE(m.box.size().z, 1.0);
    }

    void boxSeenThroughARotation() {
        const SurfaceMeasurer measurer = measurerOf(makeCube(2, 1.0f));
        const double r = std::sqrt(0.5);
        const Box box =
            measurer.boxThrough(glm::dmat3({r, r, 0}, {-r, r, 0}, {0, 0, 1}), glm::dvec3(10, 0, 0));
        QVERIFY(near(box.size().x, 2.0 * std::sqrt(2.0), 1e-12) && near(box.size().z, 2.0, 1e-12));
        QVERIFY(near(box.min.x, 10.0 - std::sqrt(2.0), 1e-12));
    }
};

HITSCOPE_TEST(SurfaceMeasuresTest, QCoreApplication)

}  // namespace hitscope::surface_measures_test

#include "surface_measures_test.moc"
