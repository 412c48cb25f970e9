// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/coordinate_change.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::coordinate_change_test {

class CoordinateChangeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void turnsAndScales() {
        MeshData mesh;
        mesh.positions = {{1.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 0.0f}};
        mesh.normals = {{0.0f, 0.0f, 1.0f}};
        mesh.sourceHash = 5;
        QVERIFY(changeCoordinates(mesh, {.scale = 0.5, .from = UpAxis::Z, .to = UpAxis::Y}).ok());
        QVERIFY(mesh.positions[0] == glm::vec3(0.5f, 1.5f, -1.0f));
        QVERIFY(!std::signbit(mesh.positions[1].z));
        QVERIFY(mesh.normals[0] == glm::vec3(0.0f, 1.0f, 0.0f));  // up stays up
        QCOMPARE(mesh.sourceHash, std::uint64_t{0});
        QVERIFY(changeCoordinates(mesh, {.scale = 2.0, .from = UpAxis::Y, .to = UpAxis::Z}).ok());
        QVERIFY(mesh.positions[0] == glm::vec3(1.0f, 2.0f, 3.0f));
        QVERIFY(mesh.normals[0] == glm::vec3(0.0f, 0.0f, 1.0f));
    }

    void nothingChangesNothing() {
        MeshData mesh;
        mesh.positions = {{1.0f, 2.0f, 3.0f}};
        mesh.sourceHash = 5;
        QVERIFY(changeCoordinates(mesh, {}).ok());
        QVERIFY(changeCoordinates(mesh, {.scale = 1.0, .from = UpAxis::Z, .to = UpAxis::Z}).ok());
        QCOMPARE(mesh.sourceHash, std::uint64_t{5});
    }

    /// What was placed far from the file's origin has the file's numbers changed, and its own alike.
    void placementFollows() {
        MeshData mesh = makeHighPolyCube(2.0f);
        mesh.filePositions.clear();
        for (const glm::vec3& position : mesh.positions) {
            mesh.filePositions.push_back(glm::dvec3(position) * 4.0 + glm::dvec3(1.0e7, 0.0, 0.0));
        }
        place(mesh, 1.0f);
        const glm::dvec3 before = mesh.filePositions[3];
        QVERIFY(changeCoordinates(mesh, {.scale = 10.0, .from = UpAxis::Y, .to = UpAxis::Z}).ok());
        QVERIFY(mesh.filePositions[3] == glm::dvec3(10.0 * before.x, -10.0 * before.z, 10.0 * before.y));
        const glm::dvec3 local = mesh.placement.toLocal(mesh.filePositions[3]);
        QVERIFY(glm::length(local - glm::dvec3(mesh.positions[3])) < 1.0e-6);
    }

    void whatIsNoFloatIsRefused() {
        MeshData mesh;
        mesh.positions = {{1.0e38f, 0.0f, 0.0f}};
        QVERIFY(!changeCoordinates(mesh, {.scale = 10.0}).ok());
        QVERIFY(mesh.positions[0] == glm::vec3(1.0e38f, 0.0f, 0.0f));
        QVERIFY(!changeCoordinates(mesh, {.scale = 0.0}).ok());
        QVERIFY(!changeCoordinates(mesh, {.scale = -1.0}).ok());
    }
};

HITSCOPE_TEST(CoordinateChangeTest, QCoreApplication)

}  // namespace hitscope::coordinate_change_test

#include "coordinate_change_test.moc"
