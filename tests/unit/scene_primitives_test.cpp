// SPDX-License-Identifier: GPL-3.0-or-later
// Primitives of any fineness, as meshes and as targets.
#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "mesh/geodesic_sphere.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "mesh/surface/surface_measurer.h"
#include "session/primitive_target.h"
#include "session/session.h"
#include "session/target.h"
#include "support/test_program.h"

namespace hitscope::scene_primitives_test {

namespace {

glm::vec3 faceNormal(const MeshData& mesh, std::size_t f) {
    const auto face = mesh.face(f);
    const glm::vec3 a = mesh.positions[face[0]];
    return glm::normalize(glm::cross(mesh.positions[face[1]] - a, mesh.positions[face[2]] - a));
}

}  // namespace

class ScenePrimitivesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void areWhole_data() {
        QTest::addColumn<MeshData>("mesh");
        QTest::addColumn<std::size_t>("vertices");
        QTest::addColumn<std::size_t>("faces");
        QTest::addColumn<qlonglong>("euler");
        QTest::addColumn<bool>("watertight");
        QTest::addColumn<double>("volume");
        const double pi = std::numbers::pi;
        QTest::newRow("icosahedron") << makeGeodesicSphere(1, 2.0f) << std::size_t{12} << std::size_t{20}
                                     << 2LL << true << 20.29;
        QTest::newRow("geodesic") << makeGeodesicSphere(30, 2.0f) << std::size_t{9002} << std::size_t{18000}
                                  << 2LL << true << 4.0 / 3.0 * pi * 8.0;
        QTest::newRow("odd geodesic") << makeGeodesicSphere(7, 2.0f) << std::size_t{492} << std::size_t{980}
                                      << 2LL << true << 4.0 / 3.0 * pi * 8.0;
        QTest::newRow("torus") << makeTorus(120, 60, 2.0f, 0.5f) << std::size_t{7200} << std::size_t{7200}
                               << 0LL << true << 2.0 * pi * pi * 2.0 * 0.25;
        QTest::newRow("cylinder") << makeCylinder(90, 30, 15, 2.0f, 3.0f)
                                  << std::size_t{90 * (31 + 2 * 14) + 2} << std::size_t{90 * (30 + 30)} << 2LL
                                  << true << pi * 4.0 * 3.0;
        QTest::newRow("prism") << makeCylinder(3, 1, 1, 2.0f, 3.0f) << std::size_t{8} << std::size_t{9} << 2LL
                               << true << 0.0;
        QTest::newRow("sheet") << makeSheet(4, 3, 2.0f, 1.0f) << std::size_t{20} << std::size_t{12} << 1LL
                               << false << 0.0;
    }
    void areWhole() {
        QFETCH(MeshData, mesh);
        QFETCH(std::size_t, vertices);
        QFETCH(std::size_t, faces);
        QFETCH(qlonglong, euler);
        QFETCH(bool, watertight);
        QFETCH(double, volume);
        QVERIFY(validate(mesh).ok());
        QCOMPARE(mesh.vertexCount(), vertices);
        QCOMPARE(mesh.faceCount(), faces);
        const auto shared = std::make_shared<const MeshData>(mesh);
        const SurfaceMeasurer measurer(shared, SurfaceTopology::build(mesh));
        const SurfaceStatistics& topology = measurer.topology().statistics();
        QCOMPARE(topology.isSolid(), watertight);
        QCOMPARE(topology.eulerCharacteristic, euler);
        QVERIFY(topology.isManifold());
        QCOMPARE(topology.opposedEdges, std::size_t{0});
        QCOMPARE(topology.unreferencedVertices, std::size_t{0});
        if (volume > 0.0) {
            const double made = measurer.measures().volume();
            QVERIFY2(std::abs(made / volume - 1.0) < 0.03, qPrintable(QString::number(made)));
        }
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            for (std::uint32_t c = mesh.faceStarts[f]; c < mesh.faceStarts[f + 1]; ++c) {
                const glm::vec3 normal = mesh.normals[mesh.cornerNormals[c]];
                QVERIFY(std::abs(glm::length(normal) - 1.0f) < 1.0e-5f);
                QVERIFY(glm::dot(normal, faceNormal(mesh, f)) > 0.4f);  // outwards, both
            }
        }
    }

    void geodesicTrianglesAreNearlyAlike() {
        const MeshData mesh = makeGeodesicSphere(16, 1.0f);
        float shortest = 10.0f;
        float longest = 0.0f;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            for (std::size_t i = 0; i < 3; ++i) {
                const float length =
                    glm::distance(mesh.positions[mesh.face(f)[i]], mesh.positions[mesh.face(f)[(i + 1) % 3]]);
                shortest = std::min(shortest, length);
                longest = std::max(longest, length);
            }
        }
        QVERIFY(longest < 1.5f * shortest);
    }

    void usualSizeSuitsTheScene_data() {
        QTest::addColumn<float>("extent");
        QTest::addColumn<float>("size");
        QTest::newRow("paper's") << 5.0f << 5.0f;
        QTest::newRow("near") << 0.6f << 5.0f;
        QTest::newRow("hand") << 0.23f << 0.2f;
        QTest::newRow("grain") << 0.002f << 0.002f;
        QTest::newRow("ship") << 270.0f << 200.0f;
        QTest::newRow("hill") << 7000.0f << 5000.0f;
    }
    void usualSizeSuitsTheScene() {
        QFETCH(float, extent);
        Session session;
        QCOMPARE(usualPrimitiveSize(session), 5.0f);
        loadMesh(session, makeHighPolySphere(0.5f * extent));
        QTEST(usualPrimitiveSize(session), "size");
    }

    /// What has coordinates of its own, from a file, keeps them.
    void shapesComeBesideAFarScene() {
        Session session;
        TargetPlan building = planMesh(makeCube(2, 30.0f), QStringLiteral("/building.obj"));
        building.transform.position = {1000, 80, -500};
        session.loadScene({QStringLiteral("Far"), {building}, 50.0f});
        session.targets().add({planPrimitive({PrimitiveKind::Cube, 2, 5.0f})});
        const Bounds here = session.targets().front()->worldBounds();
        const Bounds cube = session.targets().back()->worldBounds();
        QVERIFY(glm::distance(cube.centre(), here.centre()) < here.diagonal());
        QVERIFY(std::abs(cube.min.y - 50.0f) < 1.0e-3f);
        QVERIFY(cube.min.x >= here.max.x);
        session.targets().add({planMesh(makeCube(2, 1.0f), QStringLiteral("/other.obj"))});
        QCOMPARE(session.targets().back()->transform.position.x, 0.0f);
    }

    /// Wherever that is.
    void shapesStandOnTheFloor() {
        Session session;
        TargetPlan spider = planMesh(makeCube(2, 30.0f), QStringLiteral("/spider.obj"));
        session.loadScene({QStringLiteral("Spider"), {spider}});
        const float floor = session.targets().floorHeight();
        QVERIFY(floor < -29.0f);
        session.targets().add({planPrimitive({PrimitiveKind::UvSphere, 16, 5.0f})});
        QVERIFY(std::abs(session.targets().back()->worldBounds().min.y - floor) < 1.0e-3f);
    }

    /// No face is smeared over the whole picture where the globe's first meridian meets its last.
    void seamIsStitched() {
        for (const int frequency : {2, 7, 16}) {
            const MeshData mesh = makeGeodesicSphere(frequency, 1.0f);
            for (std::size_t c = 0; c < mesh.cornerTexcoords.size(); c += 3) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const glm::vec2 a = mesh.texcoords[mesh.cornerTexcoords[c + i]];
                    const glm::vec2 b = mesh.texcoords[mesh.cornerTexcoords[c + (i + 1) % 3]];
                    QVERIFY(std::abs(a.x - b.x) <= 0.5f);
                }
            }
        }
    }

    void standOnTheGroundAndCountTheirVertices_data() {
        QTest::addColumn<int>("kind");
        for (const PrimitiveTraits& traits : allPrimitives()) {
            QTest::newRow(qPrintable(primitiveName(traits.kind))) << static_cast<int>(traits.kind);
        }
    }
    void standOnTheGroundAndCountTheirVertices() {
        QFETCH(int, kind);
        const PrimitiveTraits& traits = traitsOf(static_cast<PrimitiveKind>(kind));
        QCOMPARE(static_cast<int>(traits.kind), kind);
        for (const int resolution : {traits.least, traits.least + 1, traits.usual, traits.usual + 7, -5}) {
            const Primitive primitive{traits.kind, resolution, 3.0f};
            const TargetPlan plan = planPrimitive(primitive);
            QVERIFY(validate(*plan.shape.mesh).ok());
            QCOMPARE(plan.shape.mesh->vertexCount(), vertexCount(primitive));
            const Bounds bounds = worldBounds(*plan.shape.render, plan.transform);
            QVERIFY(std::abs(bounds.min.y) < 1.0e-5f);
            const glm::vec3 size = bounds.size();
            const float extent = std::max({size.x, size.y, size.z});
            QVERIFY(extent < 3.001f);
            QVERIFY(resolution < traits.usual || extent > 2.98f);
        }
        // The finest has about 2,000,000 triangles, or the vertices that go with them.
        const double most = static_cast<double>(vertexCount({traits.kind, traits.most, 3.0f}));
        QVERIFY2(most > 0.85e6 && most < 1.15e6, qPrintable(QString::number(most)));
    }

    /// Of any mesh at any size: it stands in the middle, nothing overlaps, and undo takes it back.
    void turntablesFitUnderTargets() {
        for (const float size : {1.0e-3f, 5.0f, 3.0e4f}) {
            Session session;
            TargetPlan torus = planPrimitive({PrimitiveKind::Torus, 24, size});
            torus.transform.position += size * glm::vec3(3, 0, -2);
            std::vector<TargetPlan> plans(1, torus);
            session.loadScene({QStringLiteral("one"), std::move(plans)});
            const TargetId id = session.targets().front()->id;
            const Bounds before = session.targets().front()->worldBounds();
            QVERIFY(putOnTurntable(session, id).ok());
            QCOMPARE(session.targets().size(), std::size_t{2});
            QCOMPARE(session.targets().selected(), id);
            const Bounds on = session.targets()[0]->worldBounds();
            const Bounds table = session.targets()[1]->worldBounds();
            QVERIFY(glm::distance(glm::vec2(table.centre().x, table.centre().z),
                                  glm::vec2(on.centre().x, on.centre().z)) < 1e-4f * size);
            QVERIFY(std::abs(table.min.y - before.min.y) < 1e-4f * size);
            QVERIFY(on.min.y >= table.max.y && on.min.y - table.max.y < 1e-3f * size);
            QVERIFY(table.size().x > on.size().x && table.size().z > on.size().z);
            QCOMPARE(session.steps().done(), std::size_t{1});
            session.undo();
            QCOMPARE(session.targets().size(), std::size_t{1});
            QCOMPARE(session.targets()[0]->worldBounds().min.y, before.min.y);
        }
        Session empty;
        QVERIFY(!putOnTurntable(empty, TargetId()).ok());
    }

    void roomIsMadeOnlyWhereNeeded() {
        std::vector<TargetPlan> plans;
        for (int i = 0; i < 3; ++i) {
            plans.push_back(planPrimitive({PrimitiveKind::Cube, 1, 2.0f}));
        }
        plans[1].transform.position.z = 50.0f;
        plans[2].transform.position.y = -20.0f;
        makeRoom(plans, {}, 0.0f);
        QCOMPARE(plans[0].transform.position, glm::vec3(0, 1, 0));
        QCOMPARE(plans[1].transform.position, glm::vec3(0, 1, 50));
        QCOMPARE(plans[2].transform.position.y, 1.0f);
        QVERIFY(plans[2].transform.position.x > 2.0f);
    }
};

HITSCOPE_TEST(ScenePrimitivesTest, QCoreApplication)

}  // namespace hitscope::scene_primitives_test

#include "scene_primitives_test.moc"
