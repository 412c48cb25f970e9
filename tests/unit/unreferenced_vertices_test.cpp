// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that no face uses: hits move them as the paper's loop over all vertices does, and nothing draws,
// frames or aims at them.
#include <QTest>
#include <cmath>
#include <glm/common.hpp>

#include "deform/reference.h"
#include "io/export_obj.h"
#include "io/readers/obj_reader.h"
#include "mesh/primitives.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"
#include "unit/deform_support.h"

namespace hitscope::unreferenced_vertices_test {

using namespace test;

namespace {

/// A sphere, and as many loose vertices in and around it; one of them far away.
MeshData withLooseVertices(std::size_t loose) {
    MeshData mesh = makeUvSphere(24, 12, 1.0f);
    std::mt19937 random(3);
    for (std::size_t i = 0; i < loose; ++i) {
        const auto place = static_cast<std::ptrdiff_t>(random() % mesh.positions.size());
        mesh.positions.insert(mesh.positions.begin() + place, randomPoint(random, 1.1f));
        for (std::uint32_t& corner : mesh.cornerVertices) {
            corner += corner >= static_cast<std::uint32_t>(place) ? 1 : 0;
        }
    }
    mesh.positions.emplace_back(900.0f, 0.0f, 0.0f);
    return mesh;
}

std::vector<Hit> someHits(std::size_t count) {
    std::mt19937 random(8);
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < count; ++i) {
        hits.push_back(randomHit(random, 1.1f));
    }
    return hits;
}

/// The paper's Algorithm 3 over all vertices of the file: eq. 1, 3 and 4, each operation rounded to float.
PageVector<glm::vec3> algorithm3(PageVector<glm::vec3> positions, const std::vector<Hit>& hits) {
    for (glm::vec3& position : positions) {
        for (const Hit& hit : hits) {
            const glm::vec3 d = position - hit.point;
            const float r2 = (d.x * d.x + d.y * d.y) + d.z * d.z;
            if (r2 <= hit.constants.maxDistance * hit.constants.maxDistance) {
                const float magnitude =
                    std::min(hit.constants.power / std::sqrt(r2), hit.constants.maxMagnitude);
                position += magnitude * hit.direction;
            }
        }
    }
    return positions;
}

}  // namespace

class UnreferencedVerticesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void comeBehindThoseThatAreDrawn() {
        const MeshData mesh = withLooseVertices(200);
        QVERIFY(validate(mesh).ok());
        const RenderMesh render = buildRenderMesh(mesh);
        const RenderMesh sphere = buildRenderMesh(makeUvSphere(24, 12, 1.0f));
        QCOMPARE(render.drawnVertices, static_cast<std::uint32_t>(sphere.vertices.size()));
        QCOMPARE(render.vertices.size(), sphere.vertices.size() + 201);
        QCOMPARE(render.bounds.min, sphere.bounds.min);
        QCOMPARE(render.bounds.max, sphere.bounds.max);
        QCOMPARE(render.triangles, sphere.triangles);
        QCOMPARE(render.edges, sphere.edges);
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            QVERIFY(!render.renderVerticesOf(v).empty());
            for (const std::uint32_t r : render.renderVerticesOf(v)) {
                QVERIFY(render.vertices[r].position == mesh.positions[v]);
            }
        }
        std::uint32_t next = 0;
        for (const Cluster& cluster : render.clusters) {
            QCOMPARE(cluster.first, next);
            QVERIFY(cluster.count == kClusterVertices || &cluster == &render.clusters.back());
            next += cluster.count;
            for (std::uint32_t r = cluster.first; r < next; ++r) {
                const glm::vec3& at = render.vertices[r].position;
                QVERIFY(glm::clamp(at, cluster.bounds.min, cluster.bounds.max) == at);
            }
        }
        QCOMPARE(next, static_cast<std::uint32_t>(render.vertices.size()));
    }

    void areMovedByThePapersLoop() {
        const MeshData mesh = withLooseVertices(300);
        const RenderMesh render = buildRenderMesh(mesh);
        const std::vector<Hit> hits = someHits(60);
        ReferenceDeformation reference(render);
        reference.apply(hits);
        const PageVector<glm::vec3> should = algorithm3(mesh.positions, hits);
        std::size_t looseMoved = 0;
        for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
            for (const std::uint32_t r : render.renderVerticesOf(v)) {
                QVERIFY(reference.vertices()[r].position == should[v]);
                looseMoved += r >= render.drawnVertices && should[v] != mesh.positions[v] ? 1 : 0;
            }
        }
        QVERIFY(looseMoved > 100);
        QVERIFY(should.back() == mesh.positions.back());
    }

    // What frames and aims at a target goes by its surface.
    void changeNothingElse() {
        Session with;
        loadMesh(with, withLooseVertices(200));
        Session without;
        loadMesh(without, makeUvSphere(24, 12, 1.0f));
        QCOMPARE(with.targets()[0]->extent(), without.targets()[0]->extent());
        QCOMPARE(with.targets().bounds().max, without.targets().bounds().max);
        const std::vector<Ray> shots = demoShots(with, 40, 6);
        const std::vector<Ray> others = demoShots(without, 40, 6);
        QCOMPARE(shots.size(), others.size());
        for (std::size_t i = 0; i < shots.size(); ++i) {
            QVERIFY(shots[i].origin == others[i].origin && shots[i].direction == others[i].direction);
        }
        QCOMPARE(with.simulation().hitscan(shots[0]), without.simulation().hitscan(others[0]));
        QCOMPARE(with.hits().history().hits()[0].point, without.hits().history().hits()[0].point);
    }

    // They count as vertices that have changed, and are exported where they are.
    void countAsChangedAndAreExported() {
        const MeshData mesh =
            parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.10 0.1 0\nv 7 7 7\nf 1 2 3\n", {}).value().mesh;
        DeformedMesh deformed(std::make_shared<const MeshData>(mesh),
                              std::make_shared<const RenderMesh>(buildRenderMesh(mesh)));
        Hit hit;
        hit.point = {0.0f, 0.0f, 0.0f};
        hit.direction = {0.0f, 0.0f, -1.0f};
        ReferenceDeformation reference(deformed.render());
        reference.apply({&hit, 1});
        std::vector<std::uint32_t> moved;
        deformed.write(0, reference.vertices(), moved);
        QCOMPARE(deformed.statistics().changedVertices, std::size_t{2});
        QVERIFY(deformed.isChanged(3) && !deformed.isChanged(4));
        ObjExport what;
        what.mesh = &mesh;
        what.positions = deformed.positions();
        const QString text = QString::fromStdString(formatObj(what, {}));
        QVERIFY2(text.contains(QStringLiteral("\nv 1 0 0\nv 0 1 0\nv 0.1 0.1 -0.3\nv 7 7 7\n")),
                 qPrintable(text));
    }
};

HITSCOPE_TEST(UnreferencedVerticesTest, QCoreApplication)

}  // namespace hitscope::unreferenced_vertices_test

#include "unreferenced_vertices_test.moc"
