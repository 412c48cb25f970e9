// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "deform/deformed_mesh.h"
#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::deform_mesh_test {

namespace {

DeformedMesh deformedCube() {
    auto mesh = std::make_shared<const MeshData>(makeCube(1, 1.0f));
    return {mesh, std::make_shared<const RenderMesh>(buildRenderMesh(*mesh))};
}

/// Moves one file vertex, as a pipeline would write it: all its render vertices.
void move(DeformedMesh& deformed, std::uint32_t fileVertex, const glm::vec3& by) {
    std::vector<std::uint32_t> moved;
    for (const std::uint32_t r : deformed.render().renderVerticesOf(fileVertex)) {
        DynamicVertex vertex = deformed.render().vertices[r];
        vertex.position += by;
        deformed.write(r, std::span(&vertex, 1), moved);
    }
}

}  // namespace

class DeformedMeshTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void startsAsTheOriginal() {
        const DeformedMesh deformed = deformedCube();
        QCOMPARE(deformed.vertices().size(), std::size_t{24});
        QCOMPARE(deformed.positions().size(), std::size_t{8});
        QCOMPARE(deformed.statistics().changedVertices, std::size_t{0});
        QCOMPARE(deformed.statistics().mean, 0.0);
        QVERIFY(!deformed.isChanged(0));
    }

    void statisticsAreOfTheChangedVertices() {
        DeformedMesh deformed = deformedCube();
        move(deformed, 2, {3.0f, 0.0f, 4.0f});
        move(deformed, 5, {0.0f, -1.0f, 0.0f});
        const DisplacementStatistics statistics = deformed.statistics();
        QCOMPARE(statistics.changedVertices, std::size_t{2});
        QCOMPARE(statistics.maximum, 5.0);
        QCOMPARE(statistics.mean, 3.0);
        QCOMPARE(statistics.rms, std::sqrt(13.0));
        QVERIFY(deformed.isChanged(2) && deformed.isChanged(5) && !deformed.isChanged(3));
        QVERIFY(deformed.displacement(2) == glm::vec3(3.0f, 0.0f, 4.0f));
        QVERIFY(deformed.positions()[5] == deformed.original().positions[5] + glm::vec3(0.0f, -1.0f, 0.0f));
    }

    void whatComesBackNoLongerCounts() {
        DeformedMesh deformed = deformedCube();
        move(deformed, 1, {1.0f, 0.0f, 0.0f});
        move(deformed, 1, {0.0f, 0.0f, 0.0f});
        QVERIFY(!deformed.isChanged(1));
        QCOMPARE(deformed.statistics().changedVertices, std::size_t{0});
        move(deformed, 1, {0.0f, 2.0f, 0.0f});
        QCOMPARE(deformed.statistics().changedVertices, std::size_t{1});
        QCOMPARE(deformed.statistics().maximum, 2.0);
    }

    void writingARangeTakesAllOfIt() {
        DeformedMesh deformed = deformedCube();
        std::vector<DynamicVertex> range(deformed.vertices().begin() + 3, deformed.vertices().begin() + 9);
        for (DynamicVertex& vertex : range) {
            vertex.position.y += 0.5f;
            vertex.normal = {1.0f, 0.0f, 0.0f};
        }
        std::vector<std::uint32_t> moved;
        deformed.write(3, range, moved);
        const std::span<const std::uint32_t> fileVertices = deformed.render().fileVertices;
        QVERIFY(std::equal(moved.begin(), moved.end(), fileVertices.begin() + 3, fileVertices.begin() + 9));
        moved.clear();
        deformed.write(3, range, moved);
        QVERIFY(moved.empty());
        for (std::size_t r = 0; r < 24; ++r) {
            const bool isInside = r >= 3 && r < 9;
            QCOMPARE(deformed.vertices()[r].normal == glm::vec3(1.0f, 0.0f, 0.0f) &&
                         deformed.vertices()[r].position != deformed.render().vertices[r].position,
                     isInside);
            QVERIFY(!isInside || deformed.isChanged(deformed.render().fileVertices[r]));
        }
    }

    void resettingGivesTheOriginalBack() {
        DeformedMesh deformed = deformedCube();
        std::uint64_t revision = deformed.revision();
        move(deformed, 4, {0.0f, 0.0f, 1.0f});
        QVERIFY(deformed.revision() > revision);
        revision = deformed.revision();
        deformed.reset();
        QVERIFY(deformed.revision() > revision);
        QCOMPARE(deformed.statistics().changedVertices, std::size_t{0});
        for (std::uint32_t v = 0; v < 8; ++v) {
            QVERIFY(deformed.positions()[v] == deformed.original().positions[v]);
        }
        for (std::size_t r = 0; r < 24; ++r) {
            QVERIFY(deformed.vertices()[r].position == deformed.render().vertices[r].position);
        }
        move(deformed, 4, {0.0f, 0.0f, 1.0f});
        QCOMPARE(deformed.statistics().changedVertices, std::size_t{1});
    }
};

HITSCOPE_TEST(DeformedMeshTest, QCoreApplication)

}  // namespace hitscope::deform_mesh_test

#include "deform_mesh_test.moc"
