// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/vertex_copy.h"

#include <QTest>
#include <algorithm>

#include "core/process_memory.h"
#include "core/sanitizers.h"
#include "mesh/primitives.h"
#include "mesh/same_bits.h"
#include "support/test_program.h"

namespace hitscope::vertex_copy_test {

namespace {

bool areAsIn(const RenderMesh& mesh, std::uint32_t first, std::span<const DynamicVertex> vertices) {
    return std::equal(vertices.begin(), vertices.end(), mesh.vertices.begin() + first,
                      [](const DynamicVertex& a, const DynamicVertex& b) {
                          return sameBits(a.position, b.position) && sameBits(a.normal, b.normal);
                      });
}

}  // namespace

class VertexCopyTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aClusterIsCopiedWhenItIsAskedFor();
    void aRangeHasAllOfItsVertices();
    void aClusterIsRestored();
    void aMeshWithoutVertices();
    void whatIsNotAskedForTakesNoMemory();
};

void VertexCopyTest::aClusterIsCopiedWhenItIsAskedFor() {
    const RenderMesh mesh = buildRenderMesh(makeUvSphere(40, 30, 1.0f));
    QVERIFY(mesh.clusters.size() > 5);
    VertexCopy copy(mesh);
    QVERIFY(copy.copied().empty());
    const std::span<DynamicVertex> cluster = copy.cluster(2);
    QCOMPARE(cluster.size(), std::size_t{mesh.clusters[2].count});
    QVERIFY(areAsIn(mesh, mesh.clusters[2].first, cluster));
    QCOMPARE(copy.copied(), std::vector<std::uint32_t>{2});
    cluster[3].position.x += 1.0f;
    QCOMPARE(copy.cluster(2)[3].position.x, mesh.vertices[mesh.clusters[2].first + 3].position.x + 1.0f);
    QVERIFY(areAsIn(mesh, mesh.clusters.back().first,
                    copy.cluster(static_cast<std::uint32_t>(mesh.clusters.size() - 1))));
}

void VertexCopyTest::aRangeHasAllOfItsVertices() {
    const RenderMesh mesh = buildRenderMesh(makeUvSphere(40, 30, 1.0f));
    const auto all = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t first = 0; first < all; first += 37) {
        for (const std::uint32_t count : {0u, 1u, 63u, 64u, 65u, 200u}) {
            VertexCopy copy(mesh);
            const VertexRange range{first, std::min(count, all - first)};
            QCOMPARE(copy.range(range).size(), std::size_t{range.count});
            QVERIFY(areAsIn(mesh, first, copy.range(range)));
            QVERIFY(copy.copied().size() <= range.count / kClusterVertices + 2);
        }
    }
    VertexCopy copy(mesh);
    copy.cluster(1)[0].normal.y = 7.0f;
    QCOMPARE(copy.all().size(), mesh.vertices.size());
    QCOMPARE(copy.all()[mesh.clusters[1].first].normal.y, 7.0f);
    QVERIFY(areAsIn(mesh, 0, copy.all().first(mesh.clusters[1].first)));
    QCOMPARE(copy.copied().size(), mesh.clusters.size());
}

void VertexCopyTest::aClusterIsRestored() {
    const RenderMesh mesh = buildRenderMesh(makeUvSphere(40, 30, 1.0f));
    VertexCopy copy(mesh);
    copy.cluster(4)[0].position = glm::vec3(9.0f);
    copy.restore(4);
    copy.restore(5);
    QVERIFY(areAsIn(mesh, mesh.clusters[4].first, copy.cluster(4)));
    QVERIFY(areAsIn(mesh, mesh.clusters[5].first, copy.cluster(5)));
}

void VertexCopyTest::aMeshWithoutVertices() {
    const RenderMesh mesh;
    VertexCopy copy(mesh);
    QVERIFY(copy.all().empty());
    QVERIFY(copy.copied().empty());
}

void VertexCopyTest::whatIsNotAskedForTakesNoMemory() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("The sanitizers have a malloc of their own.");
#endif
    const double before = memoryOf(QCoreApplication::applicationPid()).resident;
    if (before == 0.0) {
        QSKIP("The system does not say what is in memory.");
    }
    RenderMesh mesh;
    mesh.vertices.resize(4'000'000);
    for (std::uint32_t first = 0; first < mesh.vertices.size(); first += kClusterVertices) {
        mesh.clusters.push_back({first, kClusterVertices, {}});
    }
    const double made = memoryOf(QCoreApplication::applicationPid()).resident;
    VertexCopy copy(mesh);
    for (std::uint32_t cluster = 0; cluster < 1000; cluster += 10) {
        copy.cluster(cluster)[0].position.x = 1.0f;
    }
    const double more = memoryOf(QCoreApplication::applicationPid()).resident - made;
    const auto whole = static_cast<double>(mesh.vertices.size() * sizeof(DynamicVertex));
    QVERIFY2(more < 0.1 * whole, qPrintable(QString::number(more)));
}

HITSCOPE_TEST(VertexCopyTest, QCoreApplication)

}  // namespace hitscope::vertex_copy_test

#include "vertex_copy_test.moc"
