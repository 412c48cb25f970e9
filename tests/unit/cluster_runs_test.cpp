// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cluster_runs.h"

#include <QTest>
#include <algorithm>
#include <set>

#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "support/test_program.h"

namespace hitscope::cluster_runs_test {

class ClusterRunsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void holdsEachElementOnce_data() {
        QTest::addColumn<MeshData>("mesh");
        QTest::newRow("nothing") << MeshData();
        QTest::newRow("one cluster") << makeLowPolyCube();
        QTest::newRow("sphere with a seam") << makeUvSphere(64, 40, 2.5f);
        QTest::newRow("cube with hard edges") << makeCube(24, 1.0f);
        QTest::newRow("teapot") << makeTeapot(10);
        MeshData striped = makeUvSphere(64, 40, 2.5f);
        striped.materials.resize(3);
        for (std::size_t face = 0; face < striped.faceCount(); ++face) {
            striped.faceMaterials.push_back(static_cast<std::uint32_t>(face % 3));
        }
        QTest::newRow("three materials") << striped;
    }
    void holdsEachElementOnce() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        check(render, render.triangleRuns, render.triangles, 3);
        check(render, ClusterRuns(render.vertices, render.edges, 2, {}), render.edges, 2);
        const auto runs = render.triangleRuns.runs();
        for (const DrawRange& draw : render.draws) {
            const auto isStart = [&draw](const ClusterRuns::Run& run) { return run.first == draw.first; };
            QVERIFY(std::any_of(runs.begin(), runs.end(), isStart));
        }
    }

private:
    static void check(const RenderMesh& mesh, const ClusterRuns& runs, std::span<const std::uint32_t> indices,
                      std::size_t corners) {
        std::uint32_t next = 0;
        for (std::size_t i = 0; i < runs.runs().size(); ++i) {
            const ClusterRuns::Run& run = runs.runs()[i];
            QCOMPARE(run.first, next);
            QVERIFY(run.end > run.first);
            next = run.end;
            std::set<std::uint32_t> others;
            Bounds bounds;
            for (std::size_t element = run.first; element < run.end; element += corners) {
                std::uint32_t lowest = kNoIndex;
                for (const std::uint32_t vertex : indices.subspan(element, corners)) {
                    lowest = std::min(lowest, vertex);
                    others.insert(clusterOf(mesh, vertex));
                    bounds.add(mesh.vertices[vertex].position);
                }
                QCOMPARE(clusterOf(mesh, lowest), run.cluster);
            }
            QCOMPARE(run.bounds.min, bounds.min);
            QCOMPARE(run.bounds.max, bounds.max);
            others.erase(run.cluster);
            const std::span<const std::uint32_t> found = runs.others(i);
            QCOMPARE(found.size(), others.size());
            QVERIFY(std::set<std::uint32_t>(found.begin(), found.end()) == others);
        }
        QCOMPARE(next, static_cast<std::uint32_t>(indices.size()));
    }
    static std::uint32_t clusterOf(const RenderMesh& mesh, std::uint32_t vertex) {
        std::uint32_t cluster = 0;
        while (vertex >= mesh.clusters[cluster].first + mesh.clusters[cluster].count) {
            ++cluster;
        }
        return cluster;
    }
};

HITSCOPE_TEST(ClusterRunsTest, QCoreApplication)

}  // namespace hitscope::cluster_runs_test

#include "cluster_runs_test.moc"
