// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cluster_edges.h"

#include <QTest>
#include <set>

#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "support/test_program.h"

namespace hitscope::cluster_edges_test {

class ClusterEdgesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void holdsEachEdgeOnce_data() {
        QTest::addColumn<MeshData>("mesh");
        QTest::newRow("nothing") << MeshData();
        QTest::newRow("one cluster") << makeLowPolyCube();
        QTest::newRow("sphere with a seam") << makeUvSphere(64, 40, 2.5f);
        QTest::newRow("cube with hard edges") << makeCube(24, 1.0f);
        QTest::newRow("teapot") << makeTeapot(10);
    }
    void holdsEachEdgeOnce() {
        QFETCH(MeshData, mesh);
        const RenderMesh render = buildRenderMesh(mesh);
        const ClusterEdges edges(render);
        std::uint32_t next = 0;
        for (std::size_t cluster = 0; cluster < render.clusters.size(); ++cluster) {
            const ClusterEdges::Run run = edges.of(cluster);
            QCOMPARE(run.first, next);
            next = run.end;
            std::set<std::uint32_t> ends;
            for (std::uint32_t edge = run.first; edge < run.end; ++edge) {
                QCOMPARE(clusterOf(render, render.edges[2 * std::size_t{edge}]), cluster);
                ends.insert(
                    static_cast<std::uint32_t>(clusterOf(render, render.edges[2 * std::size_t{edge} + 1])));
            }
            ends.erase(static_cast<std::uint32_t>(cluster));
            const std::span<const std::uint32_t> found = edges.endsOf(cluster);
            QCOMPARE(found.size(), ends.size());
            QVERIFY(std::set<std::uint32_t>(found.begin(), found.end()) == ends);
        }
        QCOMPARE(next, static_cast<std::uint32_t>(render.edges.size() / 2));
    }

private:
    static std::size_t clusterOf(const RenderMesh& mesh, std::uint32_t vertex) {
        std::size_t cluster = 0;
        while (vertex >= mesh.clusters[cluster].first + mesh.clusters[cluster].count) {
            ++cluster;
        }
        return cluster;
    }
};

HITSCOPE_TEST(ClusterEdgesTest, QCoreApplication)

}  // namespace hitscope::cluster_edges_test

#include "cluster_edges_test.moc"
