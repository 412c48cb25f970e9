// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and points of a mesh in glTF: as primitives of their own, beside faces or alone.
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include "glb_support.h"
#include "io/check/written_check.h"
#include "io/writers/mesh_export.h"
#include "mesh/corner_normals.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_write_gltf_lines_test {

using namespace test;

namespace {

/// Without its faces and what they have.
void takeFacesAway(MeshData& mesh) {
    mesh.faceStarts.clear();
    mesh.cornerVertices.clear();
    mesh.cornerNormals.clear();
    mesh.cornerTexcoords.clear();
    mesh.faceMaterials.clear();
    mesh.groups.clear();
}

class TestIoWriteGltfLines : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void linesAndPointsAreWritten() {
        QTemporaryDir folder;
        DentedFile mesh(
            writeFile(folder.path(), QStringLiteral("a.obj"),
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 0 0 1\nv 1 0 1\nv 0 1 1\no one\nf 1 2 3\n"
                      "o two\nf 5 6 7\nl 5 6 4\nl 4 1\np 2 4\np 7\n"));
        mesh.normals = cornerNormals(mesh.original.mesh, 0.7853982f);
        mesh.move(5, {0.0f, 0.0f, 0.5f});
        const QString path = folder.filePath(QStringLiteral("a.glb"));
        const Result<QStringList> written = exportGltf(mesh.what(), path, {});
        QVERIFY2(written, qPrintable(messageOf(written)));
        QVERIFY(!written.value().join(u' ').contains(QStringLiteral("left out")));
        const Status same = verifyWritten(path, mesh.what());
        QVERIFY2(same, qPrintable(messageOf(same)));
        const Glb glb(path);
        QCOMPARE(brokenRule(glb), QString());
        const auto primitive = [&glb](int object, int index) {
            return glb.item("meshes", object)[QStringLiteral("primitives")].toArray()[index].toObject();
        };
        const auto vertices = [&glb, &primitive](int object, int index) {
            const QJsonObject part = primitive(object, index);
            const QJsonObject attributes = part[QStringLiteral("attributes")].toObject();
            const std::vector<float> numbers =
                floatsOf(glb, attributes[QStringLiteral("_FILE_VERTEX")].toInt());
            const QJsonObject indices = glb.item("accessors", part[QStringLiteral("indices")].toInt());
            std::vector<int> of;
            for (qsizetype i = 0; i < indices[QStringLiteral("count")].toInt(); ++i) {
                of.push_back(static_cast<int>(
                    numbers[numbersIn<std::uint16_t>(glb, indices)[static_cast<std::size_t>(i)]]));
            }
            return of;
        };
        QCOMPARE(vertices(0, 1), (std::vector<int>{3, 0}));  // no face is there: of the first object
        QCOMPARE(vertices(0, 2), (std::vector<int>{1, 3}));
        QCOMPARE(vertices(1, 1), (std::vector<int>{4, 5, 5, 3}));
        QCOMPARE(vertices(1, 2), (std::vector<int>{6}));
        QCOMPARE(primitive(1, 0)[QStringLiteral("mode")].toInt(4), 4);
        QCOMPARE(primitive(1, 1)[QStringLiteral("mode")].toInt(4), 1);
        QCOMPARE(primitive(1, 2)[QStringLiteral("mode")].toInt(4), 0);
        const QJsonObject lines = primitive(1, 1);
        QVERIFY(!lines[QStringLiteral("attributes")].toObject().contains(QStringLiteral("NORMAL")));
        const QJsonObject target = lines[QStringLiteral("targets")].toArray()[0].toObject();
        QVERIFY(!target.contains(QStringLiteral("NORMAL")));
        QCOMPARE(floatsOf(glb, target[QStringLiteral("POSITION")].toInt()),
                 (std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0.5f}));
        const MeshData back = readBack(path);  // Assimp
        QCOMPARE(back.faceCount(), std::size_t{2});
        QCOMPARE(back.lines.size(), std::size_t{3});
        QCOMPARE(back.points.size(), std::size_t{3});
    }

    void theyAreWrittenAlone_data() {
        QTest::addColumn<QByteArray>("elements");
        QTest::addColumn<QList<int>>("modes");
        QTest::newRow("lines") << QByteArray("l 1 2 3\nl 3 5\n") << QList<int>{1};
        QTest::newRow("points") << QByteArray("p 5 1\n") << QList<int>{0};
        QTest::newRow("both") << QByteArray("p 5 1\nl 2 3\n") << QList<int>{1, 0};
    }
    void theyAreWrittenAlone() {
        QFETCH(const QByteArray, elements);
        QFETCH(const QList<int>, modes);
        QTemporaryDir folder;
        DentedFile mesh(
            writeFile(folder.path(), QStringLiteral("a.obj"),
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 0 0 1\nf 1 2 3\n" + elements.toStdString()));
        takeFacesAway(mesh.original.mesh);
        mesh.move(4, {0.0f, 0.0f, 0.5f});
        for (const char* const name : {"a.glb", "a.gltf"}) {
            const QString path = folder.filePath(QLatin1String(name));
            const Result<QStringList> written = exportGltf(mesh.what(), path, {});
            QVERIFY2(written, qPrintable(messageOf(written)));
            const Status same = verifyWritten(path, mesh.what());
            QVERIFY2(same, qPrintable(messageOf(same)));
        }
        const Glb glb(folder.filePath(QStringLiteral("a.glb")));
        QCOMPARE(brokenRule(glb), QString());
        const QJsonArray primitives = glb.item("meshes", 0)[QStringLiteral("primitives")].toArray();
        QList<int> written;
        for (const QJsonValue primitive : primitives) {
            written.append(primitive.toObject()[QStringLiteral("mode")].toInt(4));
        }
        QCOMPARE(written, modes);
        // Vertices that nothing uses are there, too, and the check finds what moved elsewhere.
        MeshExport other = mesh.what();
        std::vector<glm::vec3> moved(other.positions.begin(), other.positions.end());
        moved[3].x += 1.0f;
        other.positions = moved;
        QVERIFY(messageOf(verifyWritten(folder.filePath(QStringLiteral("a.glb")), other))
                    .contains(QStringLiteral("vertex 4, deformed,")));
    }

    void nothingAtAllIsRefused() {
        QTemporaryDir folder;
        DentedFile mesh(
            writeFile(folder.path(), QStringLiteral("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        takeFacesAway(mesh.original.mesh);
        const QString path = folder.filePath(QStringLiteral("a.glb"));
        QVERIFY(messageOf(exportGltf(mesh.what(), path, {})).contains(QStringLiteral("no faces, lines")));
        QVERIFY(!QFileInfo::exists(path));
    }
};

}  // namespace

HITSCOPE_TEST(TestIoWriteGltfLines, QCoreApplication)

}  // namespace hitscope::io_write_gltf_lines_test

#include "io_write_gltf_lines_test.moc"
