// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <glm/geometric.hpp>
#include <set>

#include "mesh/render_mesh.h"
#include "mesh/surface/surface_topology.h"
#include "mesh/teapot.h"
#include "mesh/triangulate.h"
#include "support/test_program.h"

namespace hitscope::mesh_teapot_test {

class TeapotTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void topologyIsThatOfThePatches_data() {
        QTest::addColumn<int>("divisions");
        for (const int divisions : {2, 3, 16}) {
            QTest::addRow("%d", divisions) << divisions;
        }
    }
    /// The pot and the lid are discs, the handle and the spout tubes. Open, as in the real data: the rim, the
    /// lid's edge, and both ends of the handle and of the spout, which go through the body's wall.
    void topologyIsThatOfThePatches() {
        QFETCH(int, divisions);
        const auto d = static_cast<std::size_t>(divisions);
        const MeshData teapot = makeTeapot(divisions);
        QVERIFY(validate(teapot).ok());
        QCOMPARE(teapot.faceCount(), 32 * d * d);
        const SurfaceStatistics topology = SurfaceTopology::build(teapot)->statistics();
        QCOMPARE(topology.triangles, 2 * 4 * d);
        QCOMPARE(topology.quads, topology.faces - topology.triangles);
        QCOMPARE(topology.components, std::size_t{4});
        QCOMPARE(topology.boundaryEdges, 2 * 4 * d + 4 * 2 * d);
        // Two of these parts touch in one point, which counts once.
        QCOMPARE(topology.nonManifoldVertices, std::size_t{1});
        QCOMPARE(topology.eulerCharacteristic, 1LL);
        QCOMPARE(topology.unreferencedVertices, std::size_t{0});
        QCOMPARE(topology.nonManifoldEdges + topology.opposedEdges + topology.collapsedFaces, std::size_t{0});
    }

    /// Its handle and spout are flat, two quads back to back, and so no manifold.
    void theCoarsestOneIsSound() {
        const MeshData teapot = makeTeapot(1);
        QVERIFY(validate(teapot).ok());
        QCOMPARE(teapot.faceCount(), std::size_t{32});
        QCOMPARE(makeTeapot(0).faceCount(), std::size_t{32});
    }

    void measuresAreThePublishedOnes() {
        const MeshData teapot = makeTeapot(16);
        const Bounds bounds = teapot.bounds();
        QCOMPARE(bounds.min.y, 0.0f);
        QCOMPARE(bounds.max.y, 3.15f);
        QCOMPARE(bounds.min.x, -3.0f);
        QVERIFY(std::abs(bounds.max.x - 3.434f) < 0.001f);
        QCOMPARE(bounds.min.z, -2.0f);
        QCOMPARE(bounds.max.z, 2.0f);
    }

    void isMirroredInThePlaneOfHandleAndSpout() {
        const MeshData teapot = makeTeapot(6);
        const auto rounded = [](const glm::vec3& p, float side) {
            return std::tuple(std::lround(p.x * 1e5f), std::lround(p.y * 1e5f),
                              std::lround(side * p.z * 1e5f));
        };
        std::set<std::tuple<long, long, long>> known;
        for (const glm::vec3& position : teapot.positions) {
            known.insert(rounded(position, 1.0f));
        }
        std::size_t missing = 0;
        for (const glm::vec3& position : teapot.positions) {
            missing += known.count(rounded(position, -1.0f)) == 0 ? 1 : 0;
        }
        QVERIFY2(missing * 100 <= teapot.positions.size(), "more than rounding can explain");
    }

    void normalsAreUnitAndOnTheFacesSide() {
        const MeshData teapot = makeTeapot(16);
        for (const glm::vec3& normal : teapot.normals) {
            QVERIFY(std::abs(glm::length(normal) - 1.0f) < 1e-6f);
        }
        for (std::size_t f = 0; f < teapot.faceCount(); ++f) {
            const glm::dvec3 face = glm::normalize(doubleAreaVector(teapot.positions, teapot.face(f)));
            for (const std::uint32_t vertex : teapot.face(f)) {
                // The spout's lip is bent most: 46 degrees between a face and one of its corners.
                QVERIFY(glm::dot(face, glm::dvec3(teapot.normals[vertex])) > 0.65);
            }
        }
    }

    void looksOutwards() {
        const MeshData teapot = makeTeapot(8);
        int belly = 0;
        int poles = 0;
        int handle = 0;
        for (std::size_t v = 0; v < teapot.vertexCount(); ++v) {
            const glm::vec3 p = teapot.positions[v];
            const glm::vec3 n = teapot.normals[v];
            const float radius = glm::length(glm::vec2(p.x, p.z));
            const bool isBelly = std::abs(radius - 2.0f) < 0.05f && std::abs(p.x) < 1.9f;
            if (isBelly) {
                ++belly;
                QVERIFY(n.x * p.x + n.z * p.z > 0.0f);
            }
            if (radius == 0.0f) {
                ++poles;
                QVERIFY(glm::distance(n, glm::vec3(0.0f, p.y > 1.0f ? 1.0f : -1.0f, 0.0f)) < 1e-3f);
            }
            if (std::abs(p.z) > 0.2f && p.x < -2.2f) {  // the handle's sides
                ++handle;
                QVERIFY(n.z * p.z > 0.0f);
            }
        }
        QVERIFY(belly > 0);
        QVERIFY(poles > 1);
        QVERIFY(handle > 0);
    }

    void texcoordsCoverEachPatch() {
        const MeshData teapot = makeTeapot(4);
        for (const glm::vec2& t : teapot.texcoords) {
            QVERIFY(t.x >= 0.0f && t.x <= 1.0f && t.y >= 0.0f && t.y <= 1.0f);
        }
        // Seen from outside, pictures are not mirrored: the texture's area has the sign of the face's.
        for (std::size_t f = 0; f < teapot.faceCount(); ++f) {
            std::vector<glm::vec3> flat;
            std::vector<std::uint32_t> order;
            for (std::size_t c = teapot.faceStarts[f]; c < teapot.faceStarts[f + 1]; ++c) {
                order.push_back(static_cast<std::uint32_t>(flat.size()));
                flat.emplace_back(teapot.texcoords[teapot.cornerTexcoords[c]], 0.0f);
            }
            QVERIFY(doubleAreaVector(flat, order).z > 0.0);
        }
        QCOMPARE(buildRenderMesh(teapot).bounds.max.y, 3.15f);
    }

    void partsAreGroups() {
        const MeshData teapot = makeTeapot(2);
        QCOMPARE(teapot.groups.size(), std::size_t{4});
        QCOMPARE(teapot.groups[1].name, std::string("lid"));
        QCOMPARE(teapot.groups[1].firstFace, 16u * 4u);
    }
};

HITSCOPE_TEST(TeapotTest, QCoreApplication)

}  // namespace hitscope::mesh_teapot_test

#include "mesh_teapot_test.moc"
