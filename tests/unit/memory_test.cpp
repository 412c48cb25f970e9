// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/process_memory.h"
#include "core/sanitizers.h"
#include "mesh/primitives.h"
#include "mesh/surface/surface_topology.h"
#include "mesh/true_normals.h"
#include "session/session.h"
#include "support/test_program.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hitscope::memory_test {

class MemoryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void freedBlocksStayWithTheLibrary();
    void hitsAndTheirStepsAreSmall();
    void aMeshIsHeldOnce();
    void surfacesAreMeasuredInLittle();
    void trueNormalsShareTheRenderMesh();
    void freeAllGivesTheRoomBack();
    void largeBlocksAskForHugePages();
};

void MemoryTest::freedBlocksStayWithTheLibrary() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("The sanitizers have a malloc of their own.");
#endif
#ifdef __GLIBC__
    constexpr std::size_t kBlock = 64 << 10;
    constexpr std::size_t kBlocks = 512;
    keepFreedMemory();
    std::vector<std::unique_ptr<char[]>> blocks(kBlocks);
    for (auto& block : blocks) {
        block = std::make_unique<char[]>(kBlock);
    }
    blocks.clear();
    QVERIFY2(mallinfo2().fordblks >= kBlocks * kBlock, "the system has it back");
#else
    QSKIP("only glibc is told what to keep");
#endif
}

/// A hundred thousand shots: in the history, in the steps to undo, and for what shots strike.
void MemoryTest::hitsAndTheirStepsAreSmall() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("The sanitizers have a malloc of their own.");
#endif
#ifdef __GLIBC__
    constexpr std::size_t kHits = 100'000;
    constexpr std::size_t kMost = 270 + 270;  // bytes of a hit, with its form and group, and of a step
    Session session;
    loadTeapot(session);
    Hit hit;
    hit.target = session.targets().front()->id;
    const auto used = [] {
        const struct mallinfo2 now = mallinfo2();
        return now.uordblks + now.hblkhd;
    };
    const std::size_t before = used();
    for (std::size_t i = 0; i < kHits; ++i) {
        hit.point.x = static_cast<float>(i);
        QVERIFY(session.hits().add(hit).ok());
    }
    QCOMPARE(session.steps().size(), kHits);
    const std::size_t each = (used() - before) / kHits;
    QVERIFY2(each <= kMost, qPrintable(QString::number(each)));
#else
    QSKIP("only glibc tells what is in use");
#endif
}

/// Positions and texture coordinates of the file and as they are drawn, triangles, edges, where what is, the
/// tree that shots are aimed by.
void MemoryTest::aMeshIsHeldOnce() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("The sanitizers have a malloc of their own.");
#endif
#ifdef __GLIBC__
    constexpr std::size_t kMost = 265;  // bytes a vertex of two triangles
    const auto used = [] {
        const struct mallinfo2 now = mallinfo2();
        return now.uordblks + now.hblkhd;
    };
    MeshData mesh = makeUvSphere(600, 400, 1.0f);
    const std::size_t vertices = mesh.vertexCount();
    const std::size_t before = used();
    Session session;
    loadMesh(session, std::move(mesh), QString());
    const std::size_t each = (used() - before) / vertices;
    QVERIFY2(each <= kMost, qPrintable(QString::number(each)));
#else
    QSKIP("only glibc tells what is in use");
#endif
}

/// What the process has at most meanwhile: the edges, and the faces at a part of the vertices.
void MemoryTest::surfacesAreMeasuredInLittle() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("The sanitizers have a malloc of their own.");
#endif
#ifdef __GLIBC__
    constexpr double kMost = 45.0;  // bytes a vertex of quads, of which edges are 16
    const MeshData mesh = makeUvSphere(1400, 1000, 1.0f);
    const std::int64_t self = QCoreApplication::applicationPid();
    malloc_trim(0);
    QFile reset(QStringLiteral("/proc/self/clear_refs"));
    if (!reset.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || reset.write("5") != 1) {
        QSKIP("the system does not count the most anew");
    }
    const double before = memoryOf(self).resident;
    const std::shared_ptr<const SurfaceTopology> topology = SurfaceTopology::build(mesh);
    const double each = (memoryOf(self).most - before) / static_cast<double>(mesh.vertexCount());
    QVERIFY(topology->edges().size() > mesh.vertexCount());
    QVERIFY2(each >= 16.0 && each <= kMost, qPrintable(QString::number(each)));
#else
    QSKIP("only glibc gives memory back");
#endif
}

/// Where each vertex has one normal, what is listed for its faces alone is new: 4 bytes a vertex and a
/// corner.
void MemoryTest::trueNormalsShareTheRenderMesh() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("The sanitizers have a malloc of their own.");
#endif
#ifdef __GLIBC__
    constexpr std::size_t kMost = 21;  // bytes a vertex of quads
    constexpr std::uint32_t kSide = 500;
    auto mesh = std::make_shared<MeshData>();
    mesh->faceStarts.push_back(0);
    for (std::uint32_t v = 0; v < kSide * kSide; ++v) {
        mesh->positions.emplace_back(static_cast<float>(v % kSide), static_cast<float>(v / kSide), 0.0f);
        if (v % kSide + 1 < kSide && v / kSide + 1 < kSide) {
            mesh->cornerVertices.insert(mesh->cornerVertices.end(), {v, v + 1, v + kSide + 1, v + kSide});
            mesh->faceStarts.push_back(static_cast<std::uint32_t>(mesh->cornerVertices.size()));
        }
    }
    const auto render = std::make_shared<const RenderMesh>(buildRenderMesh(*mesh));
    const auto used = [] {
        const struct mallinfo2 now = mallinfo2();
        return now.uordblks + now.hblkhd;
    };
    const std::size_t before = used();
    const TrueNormals normals(mesh, render);
    const std::size_t each = (used() - before) / mesh->vertexCount();
    QVERIFY2(each <= kMost, qPrintable(QString::number(each)));
#else
    QSKIP("only glibc tells what is in use");
#endif
}

void MemoryTest::freeAllGivesTheRoomBack() {
    std::vector<int> values(1000, 1);
    freeAll(values);
    QCOMPARE(values.capacity(), std::size_t{0});
}

void MemoryTest::largeBlocksAskForHugePages() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("The sanitizers have an operator new of their own.");
#endif
    if (!QFile::exists(QStringLiteral("/sys/kernel/mm/transparent_hugepage/enabled"))) {
        QSKIP("the system has no huge pages");
    }
    const std::vector<char> block(64 << 20);
    const auto inside = reinterpret_cast<quint64>(&block[block.size() / 2]);
    QFile maps(QStringLiteral("/proc/self/smaps"));
    QVERIFY(maps.open(QIODevice::ReadOnly));
    const QRegularExpression range(QStringLiteral("^([0-9a-f]+)-([0-9a-f]+) "));
    QByteArray flags;
    bool isIn = false;
    for (QByteArray line = maps.readLine(); !line.isEmpty(); line = maps.readLine()) {
        if (const auto match = range.match(QString::fromLatin1(line)); match.hasMatch()) {
            isIn = match.captured(1).toULongLong(nullptr, 16) <= inside &&
                   inside < match.captured(2).toULongLong(nullptr, 16);
        } else if (isIn && line.startsWith("VmFlags:")) {
            flags = line.simplified();
        }
    }
    QVERIFY2(flags.split(' ').contains("hg"), flags.constData());
}

HITSCOPE_TEST(MemoryTest, QCoreApplication)

}  // namespace hitscope::memory_test

#include "memory_test.moc"
