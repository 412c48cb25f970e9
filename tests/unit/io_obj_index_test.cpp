// SPDX-License-Identifier: GPL-3.0-or-later
// Indices of OBJ files are kept until somebody writes to the file; the plan of normals does not depend on the
// number of processors.
#include <fcntl.h>
#include <sys/stat.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "io/descriptor.h"
#include "io/writers/normal_plan.h"
#include "io/writers/obj_index_cache.h"
#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::io_obj_index_test {

namespace {

const QByteArray kBefore = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray kAfter = "v 0 0 0\nv 1 0 0\nf 1 2 2\nf 2 2 1\n";  // as many bytes

void writeFile(const QString& path, const QByteArray& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

std::shared_ptr<const ObjIndex> indexOf(const QString& path) {
    const Descriptor file(::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC));
    return indexedObj(file.get(), ObjFaces::AllLines, {});
}

std::uint32_t verticesOf(const ObjIndex& index) {
    std::uint32_t vertices = 0;
    for (const SourcePart& part : index.parts) {
        vertices += part.vertices;
    }
    return vertices;
}

/// 300,000 corners, some of which share a normal or have none.
MeshData largeMesh() {
    MeshData mesh = makeUvSphere(300, 250, 1.0f);
    for (std::uint32_t c = 0; c < mesh.cornerNormals.size(); ++c) {
        mesh.cornerNormals[c] = c % 13 == 0 ? kNoIndex : c % 7 == 0 ? c % 50 : mesh.cornerNormals[c];
    }
    return mesh;
}

}  // namespace

class ObjIndexTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { pretendedProcessors() = 0; }

    void isKeptUntilSomebodyWrites() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("mesh.obj"));
        writeFile(path, kBefore);
        const std::shared_ptr<const ObjIndex> fresh = indexOf(path);
        QVERIFY(fresh != nullptr);
        // A write within the tick of the file system's clock would not show: it was not kept.
        QVERIFY(indexOf(path) != fresh);
        QTest::qSleep(3500);
        const std::shared_ptr<const ObjIndex> settled = indexOf(path);
        QCOMPARE(settled->hash, fresh->hash);
        QCOMPARE(indexOf(path), settled);
        // As many bytes, and the old time of modification.
        struct stat info {};
        QCOMPARE(::stat(QFile::encodeName(path).constData(), &info), 0);
        writeFile(path, kAfter);
        const timespec times[] = {info.st_atim, info.st_mtim};
        QCOMPARE(::utimensat(AT_FDCWD, QFile::encodeName(path).constData(), times, 0), 0);
        const std::shared_ptr<const ObjIndex> after = indexOf(path);
        QVERIFY(after->hash != settled->hash);
        QCOMPARE(verticesOf(*after), 2u);
        // Another file in its place.
        writeFile(folder.filePath(QStringLiteral("other.obj")), kBefore);
        QVERIFY(QFile::remove(path));
        QVERIFY(QFile::rename(folder.filePath(QStringLiteral("other.obj")), path));
        QCOMPARE(verticesOf(*indexOf(path)), 3u);
    }

    void planIsTheSameOnAnyNumberOfProcessors_data() {
        QTest::addColumn<bool>("everywhere");
        QTest::addColumn<bool>("all");
        QTest::newRow("a few vertices") << false << false;
        QTest::newRow("a few vertices, all normals") << false << true;
        QTest::newRow("everywhere") << true << false;
        QTest::newRow("everywhere, all normals") << true << true;
    }
    void planIsTheSameOnAnyNumberOfProcessors() {
        QFETCH(bool, everywhere);
        QFETCH(bool, all);
        const MeshData mesh = largeMesh();
        QVERIFY(validate(mesh).ok());
        PageVector<glm::vec3> positions = mesh.positions;
        for (std::size_t v = 0; v < positions.size(); v += everywhere ? 1 : 9973) {
            positions[v] *= 0.9f;
        }
        std::vector<glm::vec3> normals(mesh.cornerVertices.size());
        for (std::size_t c = 0; c < normals.size(); ++c) {
            normals[c] = glm::normalize(positions[mesh.cornerVertices[c]] + 0.1f);
        }
        const std::vector<std::uint8_t> moved = movedVertices(mesh, positions);
        const CornerNormalView view{normals, {}};
        pretendedProcessors() = 1;
        const NormalPlan alone = planNormals(mesh, moved, view, all);
        QVERIFY(!alone.replaced.empty());
        QVERIFY(!alone.added.empty());
        pretendedProcessors() = 3;
        const NormalPlan shared = planNormals(mesh, moved, view, all);
        QVERIFY(shared.replaced == alone.replaced);
        QVERIFY(shared.values == alone.values);
        QVERIFY(shared.added == alone.added);
        QVERIFY(shared.corners == alone.corners);
        QVERIFY(shared.numbers == alone.numbers);
    }

    /// A normal a vertex, which corners refer to, comes to the same as one a corner.
    void planIsTheSameForSharedNormals_data() {
        QTest::addColumn<bool>("all");
        QTest::newRow("those of the file") << false;
        QTest::newRow("all normals") << true;
    }
    void planIsTheSameForSharedNormals() {
        QFETCH(bool, all);
        const MeshData mesh = largeMesh();
        PageVector<glm::vec3> positions = mesh.positions;
        for (std::size_t v = 0; v < positions.size(); v += 3) {
            positions[v] *= 0.9f;
        }
        std::vector<glm::vec3> ofVertices(positions.size());
        for (std::size_t v = 0; v < positions.size(); ++v) {
            ofVertices[v] = glm::normalize(positions[v] + 0.1f);
        }
        std::vector<glm::vec3> ofCorners(mesh.cornerVertices.size());
        for (std::size_t c = 0; c < ofCorners.size(); ++c) {
            ofCorners[c] = ofVertices[mesh.cornerVertices[c]];
        }
        const std::vector<std::uint8_t> moved = movedVertices(mesh, positions);
        const NormalPlan one = planNormals(mesh, moved, {ofVertices, mesh.cornerVertices}, all);
        const NormalPlan other = planNormals(mesh, moved, {ofCorners, {}}, all);
        QVERIFY(one.replaced == other.replaced);
        QVERIFY(one.values == other.values);
        QVERIFY(one.corners == other.corners);
        QCOMPARE(one.added.size(), other.added.size());
        for (std::size_t c = 0; c < ofCorners.size(); ++c) {
            if (one.corners.has(c)) {
                QCOMPARE(one.added[one.numberOf(c) - mesh.normals.size()], ofCorners[c]);
                QCOMPARE(other.added[other.numberOf(c) - mesh.normals.size()], ofCorners[c]);
            }
        }
    }

    void cornersAreFoundInAnyRange() {
        CornerSet corners;
        QVERIFY(!corners.has(7) && !corners.hasBetween(0, 300));
        corners.words().assign(5, 0);
        for (const std::size_t corner : {0u, 63u, 64u, 200u}) {
            corners.words()[corner / CornerSet::kBits] |= std::uint64_t{1} << corner % CornerSet::kBits;
        }
        for (std::size_t first = 0; first < 300; ++first) {
            bool has = false;
            for (std::size_t end = first; end < 300; ++end) {
                QCOMPARE(corners.hasBetween(first, end), has);
                has = has || end == 0 || end == 63 || end == 64 || end == 200;
                QCOMPARE(corners.has(end), end == 0 || end == 63 || end == 64 || end == 200);
            }
        }
    }
};

HITSCOPE_TEST(ObjIndexTest, QCoreApplication)

}  // namespace hitscope::io_obj_index_test

#include "io_obj_index_test.moc"
