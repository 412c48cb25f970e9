// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <cstring>

#include "mesh/render_mesh.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_write_stl_test {

using namespace test;

namespace {

/// A notched polygon, which no fan fills, a quad and a triangle.
const char* const kPolygons =
    "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 2 1 0\nv 0 3 0\nv 0 0 2\nv 4 0 2\nf 1 2 3 4 5\nf 1 6 7 2\nf 3 2 7\n";

class TestIoWriteStl : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void trianglesAsDrawn_data() {
        QTest::addColumn<bool>("isAscii");
        QTest::newRow("binary") << false;
        QTest::newRow("ascii") << true;
    }
    void trianglesAsDrawn() {
        QFETCH(bool, isAscii);
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kPolygons));
        mesh.move(3, {0.0f, 0.0f, -0.3f});
        const QString path = folder.filePath(QStringLiteral("b.stl"));
        const Result<QStringList> written = exportStl(mesh.what(), path, {.isAscii = isAscii});
        QVERIFY2(written, qPrintable(messageOf(written)));
        QVERIFY(written.value().join(u' ').contains(QStringLiteral("polygons")));
        const MeshData back = readBack(path);
        QCOMPARE(back.faceCount(), std::size_t{6});
        const RenderMesh render = buildRenderMesh(mesh.original.mesh);
        std::size_t found = 0;
        for (std::size_t t = 0; t < 6; ++t) {
            for (std::size_t f = 0; f < 6; ++f) {
                bool same = true;
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::uint32_t vertex = render.fileVertices[render.triangles[3 * t + i]];
                    same = same && back.positions[back.face(f)[i]] == mesh.positions[vertex];
                }
                found += same ? 1 : 0;
            }
        }
        QCOMPARE(found, std::size_t{6});
    }

    void normalsAreOfTheDeformedFacets() {
        QTemporaryDir folder;
        DentedFile mesh(
            writeFile(folder.path(), QStringLiteral("a.obj"), "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n"));
        mesh.positions[2] = {0.0f, 0.0f, 3.0f};
        const QString path = folder.filePath(QStringLiteral("b.stl"));
        QVERIFY(exportStl(mesh.what(), path, {}));
        const std::string bytes = readFile(path);
        QCOMPARE(bytes.size(), std::size_t{134});
        QVERIFY(!bytes.starts_with("solid"));
        glm::vec3 normal;
        std::memcpy(static_cast<void*>(&normal), bytes.data() + 84, sizeof normal);
        QCOMPARE(normal, glm::vec3(0.0f, -1.0f, 0.0f));
        QVERIFY(exportStl(mesh.what(), path, {.isAscii = true}));
        QVERIFY(readFile(path).find("facet normal 0 -1 0\n") != std::string::npos);
    }

    /// There is no place in the file for it, so the export says so.
    void newVerticesAreSaidToBeLeftOut() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kPolygons));
        const QString path = folder.filePath(QStringLiteral("b.stl"));
        const auto saysSo = [&] {
            return exportStl(mesh.what(), path, {}).value().join(u' ').contains(QStringLiteral("are new"));
        };
        QVERIFY(!saysSo());
        mesh.original.mesh.sourceVertices = {0, 1, 2, 3, 4, 5, 6};
        QVERIFY(!saysSo());
        mesh.original.mesh.sourceVertices[6] = kNoIndex;
        QVERIFY(saysSo());
    }

    void givenUpNothingIsWritten() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kPolygons));
        MeshExport what = mesh.what();
        what.goOn = [](ExportStep, double fraction) { return fraction < 1.0; };
        const QString path = folder.filePath(QStringLiteral("b.stl"));
        QVERIFY(!exportStl(what, path, {}));
        QVERIFY(!QFileInfo::exists(path));
        what.hits = what.hits.first(1);
        QVERIFY(messageOf(exportStl(what, path, {})).contains(QStringLiteral("same vertices")));
    }

    void changesAsCsv() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), kPolygons));
        mesh.move(3, {0.5f, 0.0f, -0.25f});
        const QString path = folder.filePath(QStringLiteral("b.csv"));
        QVERIFY(exportChangesCsv(mesh.what(), path, {}));
        const std::string head =
            "vertex,original_x,original_y,original_z,current_x,current_y,current_z,displacement_x,"
            "displacement_y,"
            "displacement_z,displacement,hits\n";
        QCOMPARE(readFile(path), head + "4,2,1,0,2.5,1,-0.25,0.5,0,-0.25,0.5590169943749475,1\n");
        MeshExport what = mesh.what();
        what.hits = {};
        QVERIFY(exportChangesCsv(what, path, {.allVertices = true}));
        const std::string all = readFile(path);
        QCOMPARE(std::count(all.begin(), all.end(), '\n'), std::ptrdiff_t{8});
        QVERIFY(all.find("\n5,0,3,0,0,3,0,0,0,0,0\n") != std::string::npos);
        place(mesh.original.mesh, 0.4f);
        mesh.positions.assign(mesh.original.mesh.positions.begin(), mesh.original.mesh.positions.end());
        mesh.move(3, {0.05f, 0.0f, 0.0f});
        QVERIFY(exportChangesCsv(mesh.what(), path, {}));
        QVERIFY2(readFile(path).starts_with(head + "4,2,1,0,2.5"), readFile(path).c_str());
    }
};

}  // namespace

HITSCOPE_TEST(TestIoWriteStl, QCoreApplication)

}  // namespace hitscope::io_write_stl_test

#include "io_write_stl_test.moc"
