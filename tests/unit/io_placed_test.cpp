// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "io/check/written_check.h"
#include "io/export_obj.h"
#include "io/writers/merge_targets.h"
#include "random_obj.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_placed_test {

using namespace test;

namespace {

const glm::dmat4 kShift = glm::translate(glm::dmat4(1.0), glm::dvec3(10.0, 0.0, 0.0));
const glm::dmat4 kTurn = glm::rotate(kShift, glm::radians(90.0), glm::dvec3(0.0, 0.0, 1.0));

/// Exported in the coordinates of the scene.
class Placed {
public:
    Placed(const DentedFile& mesh, const glm::dmat4& transform) : m_mesh(mesh) {
        PlacedTarget target;
        target.mesh = &mesh.original.mesh;
        target.positions = mesh.positions;
        target.normals = mesh.normals;
        target.hits = mesh.hits;
        target.transform = transform;
        target.sourcePath = mesh.sourcePath;
        m_placed = placeTarget(target);
        m_what = m_placed.what();
        m_what.sourcePath = mesh.sourcePath;
        m_what.asRead = &mesh.original.mesh;
    }
    [[nodiscard]] const MeshExport& what() const { return m_what; }
    Result<QStringList> writeObj(const QString& path) const {
        ObjExport what;
        what.mesh = m_what.mesh;
        what.positions = m_what.positions;
        what.normals = {m_what.normals, {}};
        what.sourceFolder = QFileInfo(m_mesh.sourcePath).absolutePath();
        what.sourcePath = m_mesh.sourcePath;
        what.asRead = m_what.asRead;
        return exportObj(what, path);
    }

private:
    const DentedFile& m_mesh;
    MergedTargets m_placed;
    MeshExport m_what;
};

/// The file's own, of unit length.
void giveNormals(DentedFile& mesh) {
    const MeshData& data = mesh.original.mesh;
    for (std::size_t c = 0; c < data.cornerNormals.size(); ++c) {
        const std::uint32_t normal = data.cornerNormals[c];
        mesh.normals.push_back(normal == kNoIndex ? glm::vec3(0, 1, 0)
                                                  : glm::normalize(data.normals[normal]));
    }
}

class TestIoPlaced : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void objKeepsItsText_data() {
        QTest::addColumn<bool>("isTurned");
        QTest::addColumn<bool>("isMoved");
        QTest::addColumn<QByteArray>("wanted");
        QTest::newRow("shifted") << false << false
                                 << QByteArray(
                                        "# a plate\r\nv 10 0.0 0 1.0\nv 11 0 -0\nv 10 1e0 0.5\nvn 0 "
                                        "2 0\n\nf 1//1 2//1 \\\n 3//1 # end\n");
        QTest::newRow("shifted, dented")
            << false << true
            << QByteArray(
                   "# a plate\r\nv 10 0.0 0 1.0\nv 11 0.25 -0\nv 10 1e0 0.5\nvn 0 "
                   "2 0\n\nf 1//1 2//1 \\\n 3//1 # end\n");
        QTest::newRow("turned") << true << false
                                << QByteArray(
                                       "# a plate\r\nv 10 0.0 0 1.0\nv 10 1 -0\nv 9 0 0.5\nvn -1 0 "
                                       "0\n\nf 1//1 2//1 \\\n 3//1 # end\n");
    }
    void objKeepsItsText() {
        QFETCH(bool, isTurned);
        QFETCH(bool, isMoved);
        QFETCH(QByteArray, wanted);
        const QTemporaryDir folder;
        DentedFile plate(writeFile(folder.path(), QStringLiteral("p.obj"),
                                   "# a plate\r\nv 0 0.0 0 1.0\nv 1 0 -0\nv 0 1e0 0.5\nvn 0 2 0\n\nf 1//1 "
                                   "2//1 \\\n 3//1 # end\n"));
        giveNormals(plate);
        if (isMoved) {
            plate.move(1, {0.0f, 0.25f, 0.0f});
        }
        glm::dmat4 turn = kTurn;
        turn[0] = {0.0, 1.0, 0.0, 0.0};  // without what a sine of 90 degrees lacks
        turn[1] = {-1.0, 0.0, 0.0, 0.0};
        const Placed placed(plate, isTurned ? turn : kShift);
        const QString path = folder.filePath(QStringLiteral("world.obj"));
        const Result<QStringList> written = placed.writeObj(path);
        QVERIFY2(written, qPrintable(messageOf(written)));
        QCOMPARE(written.value(), QStringList());
        QCOMPARE(QByteArray::fromStdString(readFile(path)), wanted);
        const Status same = verifyWritten(path, placed.what());
        QVERIFY2(same, qPrintable(messageOf(same)));
    }

    void anyObjIsWhatWasMeant() {
        const QTemporaryDir folder;
        std::mt19937 random(11);
        int tried = 0;
        while (tried < 60) {
            const std::string text = randomObj(random);
            const QString source = writeFile(folder.path(), QStringLiteral("any.obj"), text);
            if (!readMesh(source, {})) {
                continue;  // a comment that goes on took vertices away
            }
            DentedFile mesh(source);
            giveNormals(mesh);
            const QString path = folder.filePath(QStringLiteral("out/world.obj"));
            QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("out")));
            QVERIFY(Placed(mesh, glm::dmat4(1.0)).writeObj(path));
            QCOMPARE(QByteArray::fromStdString(readFile(path)), QByteArray::fromStdString(text));
            for (std::size_t v = 0; v < mesh.positions.size(); v += 3) {
                mesh.move(v, {0.1f, 0.0f, -7.3f});
            }
            const Placed placed(mesh, ++tried % 2 == 0 ? kShift : kTurn);
            const Result<QStringList> written = placed.writeObj(path);
            QVERIFY2(written, qPrintable(messageOf(written)));
            QCOMPARE(written.value(), QStringList());
            const Status same = verifyWritten(path, placed.what());
            QVERIFY2(same, qPrintable(messageOf(same) + QString::fromStdString('\n' + text)));
        }
    }

    void plyKeepsItsProperties_data() {
        QTest::addColumn<QByteArray>("type");
        QTest::newRow("float") << QByteArray("float");
        QTest::newRow("double") << QByteArray("double");
        QTest::newRow("int") << QByteArray("int");
    }
    /// But metres are no whole numbers.
    void plyKeepsItsProperties() {
        QFETCH(QByteArray, type);
        const QTemporaryDir folder;
        const QByteArray text = "ply\nformat ascii 1.0\ncomment mine\nelement vertex 3\nproperty " + type +
                                " x\nproperty " + type + " y\nproperty " + type +
                                " z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar "
                                "heat\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                                "0 0 0 0 1 0 7\n1 0 0 0 1 0 8\n0 0 1 0 1 0 9\n3 0 2 1\n";
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("p.ply"), text.toStdString()));
        giveNormals(mesh);
        mesh.move(1, {0.0f, 0.25f, 0.0f});
        const Placed placed(mesh, kTurn);
        const QString path = folder.filePath(QStringLiteral("world.ply"));
        const Result<QStringList> written = exportPly(placed.what(), path, {});
        QVERIFY2(written, qPrintable(messageOf(written)));
        const QByteArray now = QByteArray::fromStdString(readFile(path));
        const bool isWhole = type == "int";
        QCOMPARE(now.contains("comment mine"), !isWhole);
        QCOMPARE(now.contains("property uchar heat"), !isWhole);
        QCOMPARE(written.value().join(u' ').contains(QStringLiteral("too coarse for metres")), isWhole);
        const Status same = verifyWritten(path, placed.what());
        QVERIFY2(same, qPrintable(messageOf(same)));
        const MeshData back = readBack(path);
        QVERIFY(glm::distance(back.positions[1], glm::vec3(9.75f, 1.0f, 0.0f)) < 1e-5f);
        QVERIFY(glm::distance(back.normals[back.cornerNormals[0]], glm::vec3(-1, 0, 0)) < 1e-5f);
    }
};

HITSCOPE_TEST(TestIoPlaced, QCoreApplication)

}  // namespace

}  // namespace hitscope::io_placed_test

#include "io_placed_test.moc"
