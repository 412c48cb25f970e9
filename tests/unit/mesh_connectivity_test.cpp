// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <random>

#include "mesh/primitives.h"
#include "mesh/surface/connectivity.h"
#include "mesh_support.h"
#include "support/test_program.h"

namespace hitscope::mesh_connectivity_test {

using test::meshOf;

namespace {

/// Triangles around one vertex.
MeshData fan(std::uint32_t sides, bool isShuffled) {
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < sides; ++i) {
        faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    if (isShuffled) {
        std::shuffle(faces.begin(), faces.end(), std::mt19937(3));
    }
    return meshOf(PageVector<glm::vec3>(sides + 1), faces);
}

/// Likewise, whose vertices are at different places.
MeshData fanInSpace(std::uint32_t sides) {
    MeshData mesh = fan(sides, true);
    for (std::uint32_t i = 0; i <= sides; ++i) {
        mesh.positions[i] = glm::vec3(static_cast<float>(i), 0.0f, 0.0f);
    }
    return mesh;
}

}  // namespace

class ConnectivityTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void facesThatMeetInAPointAreTwoComponents() {
        const Connectivity c = hitscope::connect(
            meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}));
        QCOMPARE(c.components, std::size_t{2});
        QCOMPARE(c.refused, std::size_t{0});
    }

    void aThirdFaceOnAnEdgeIsNotManifold() {
        const Connectivity c = hitscope::connect(meshOf(
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
        QCOMPARE(c.refused, std::size_t{1});
        QCOMPARE(c.faces, std::size_t{2});
        QCOMPARE(c.edges, std::size_t{5});
    }

    void aFaceTurnedOverIsNotManifold() {
        const Connectivity c =
            hitscope::connect(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}));
        QCOMPARE(c.refused, std::size_t{1});
    }

    void aFaceThatRepeatsAVertexIsDegenerate() {
        const Connectivity c = hitscope::connect(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                                        {{0, 1, 2}, {1, 1, 2}, {1, 3, 2, 3}, {0, 0, 0}}));
        QCOMPARE(c.faces, std::size_t{1});
        QCOMPARE(c.refused, std::size_t{0});
        QCOMPARE(c.components, std::size_t{1});
    }

    void noFaces() {
        const Connectivity c = hitscope::connect(meshOf({{0, 0, 0}}, {}));
        QCOMPARE(c.components, std::size_t{0});
        QCOMPARE(hitscope::connect(MeshData()).vertices, std::size_t{0});
    }

    /// OpenMesh is built with assertions: what it cannot hold must not reach it.
    void soupsDoNotStopTheProgram() {
        std::mt19937 random(7);
        for (int round = 0; round < 300; ++round) {
            const auto vertices = static_cast<std::uint32_t>(4 + round % 40);
            std::uniform_int_distribution<std::uint32_t> vertex(0, vertices - 1);
            std::vector<std::vector<std::uint32_t>> faces;
            for (int f = 0; f < 150; ++f) {
                std::vector<std::uint32_t> face(3 + random() % 4);
                std::generate(face.begin(), face.end(), [&] { return vertex(random); });
                faces.push_back(face);
                if (f % 10 == 0) {
                    faces.push_back(face);  // twice, and turned over
                    std::reverse(face.begin(), face.end());
                    faces.push_back(face);
                }
            }
            const MeshData mesh = meshOf(PageVector<glm::vec3>(vertices), faces);
            const Connectivity c = hitscope::connect(mesh);
            QVERIFY(c.faces > 0);
            QVERIFY(c.faces + c.refused <= mesh.faceCount());
        }
    }

    /// What the surface tells spares the half-edges, and never says otherwise.
    void refusedFacesAreTheSame() {
        std::mt19937 random(11);
        std::size_t refused = 0;
        for (int round = 0; round < 300; ++round) {
            // Faces left out, turned over, doubled, in no order; vertices split as along seams.
            MeshData mesh = makeUvSphere(12, 9, 1.0f);
            std::vector<std::vector<std::uint32_t>> faces;
            const int changes = round % 4 == 0 ? 0 : round % 6;
            for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
                faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
            }
            PageVector<glm::vec3> places = mesh.positions;
            for (int i = 0; i < changes; ++i) {
                std::vector<std::uint32_t>& face = faces[random() % faces.size()];
                if (i % 3 == 0) {
                    std::reverse(face.begin(), face.end());
                } else if (i % 3 == 1) {
                    places.push_back(places[face[0]]);
                    face[0] = static_cast<std::uint32_t>(places.size() - 1);
                } else {
                    const std::vector<std::uint32_t> again = face;
                    faces.push_back(again);
                }
            }
            std::shuffle(faces.begin(), faces.end(), random);
            faces.resize(faces.size() - (round % 3 == 0 ? 0 : random() % 40));
            const MeshData made = meshOf(places, faces);
            const std::size_t found = refusedFaces(made, *SurfaceTopology::build(made));
            QCOMPARE(found, hitscope::connect(made).refused);
            refused += found;
        }
        QVERIFY(refused > 0);
        // More faces round a vertex than the gate goes round for certain.
        const MeshData many = fanInSpace(3000);
        QCOMPARE(refusedFaces(many, *SurfaceTopology::build(many)), std::size_t{0});
    }

    void largeFansInOrderAreConnected() {
        QCOMPARE(hitscope::connect(fan(100000, false)).refused, std::size_t{0});
        const Connectivity shuffled = hitscope::connect(fan(3000, true));
        QCOMPARE(shuffled.vertices + shuffled.faces, shuffled.edges + 1);
    }

    /// In no order they would take OpenMesh minutes: what is too much is left out, and said.
    void largeFansInNoOrderEnd() {
        const Connectivity c = hitscope::connect(fan(100000, true));
        QVERIFY(c.refused > 0 && c.refused < 100000);
        QCOMPARE(c.faces + c.refused, std::size_t{100000});
    }
};

HITSCOPE_TEST(ConnectivityTest, QCoreApplication)

}  // namespace hitscope::mesh_connectivity_test

#include "mesh_connectivity_test.moc"
