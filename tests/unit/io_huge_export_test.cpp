// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes near the largest float, dented to where a file has no numbers: no export holds "inf".
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <limits>

#include "io/check/written_check.h"
#include "io/export_obj.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_huge_export_test {

using namespace test;

namespace {

/// A square from -3.4e38 to 3.4e38, 1 m across where it is shown.
constexpr std::string_view kHuge =
    "v -3.4e38 -3.4e38 0\nv 3.4e38 -3.4e38 0\nv 3.4e38 3.4e38 0\nv -3.4e38 3.4e38 0\nf 1 2 3 4\n";
/// The same, as its own format has it.
constexpr std::string_view kHugePly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "-3.4e38 -3.4e38 0\n3.4e38 -3.4e38 0\n3.4e38 3.4e38 0\n-3.4e38 3.4e38 0\n4 0 1 2 3\n";

Result<QStringList> write(const MeshExport& what, const QString& path) {
    if (path.endsWith(QStringLiteral(".obj"))) {
        ObjExport obj;
        obj.mesh = what.mesh;
        obj.positions = what.positions;
        obj.sourcePath = what.sourcePath.endsWith(QStringLiteral(".obj")) ? what.sourcePath : QString();
        return exportObj(obj, path);
    }
    return path.endsWith(QStringLiteral(".ply"))   ? exportPly(what, path)
           : path.endsWith(QStringLiteral(".stl")) ? exportStl(what, path)
           : path.endsWith(QStringLiteral(".csv")) ? exportChangesCsv(what, path)
                                                   : exportGltf(what, path, {.steps = !what.steps.empty()});
}

bool holdsDisplacements(const QString& suffix) {
    return suffix != QStringLiteral("obj") && suffix != QStringLiteral("stl");
}

}  // namespace

class TestIoHugeExport : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_obj = writeFile(m_folder->path(), QStringLiteral("huge.obj"), kHuge);
        m_ply = writeFile(m_folder->path(), QStringLiteral("huge.ply"), kHugePly);
    }

    void beyondFloatsIsRefused_data() { formats(); }
    void beyondFloatsIsRefused() {
        QFETCH(QString, suffix);
        for (const QString& source : {m_obj, m_ply}) {
            DentedFile mesh(source);
            QCOMPARE(mesh.positions.size(), std::size_t{4});
            QVERIFY(std::abs(mesh.positions[2].x - 0.5f) < 0.001f);
            mesh.move(2, {0.01f, 0.0f, 0.0f});
            refuses(mesh.what(), suffix, QStringLiteral("Vertex 3 is farther from the origin"));
            mesh.move(1, {0.0f, -0.01f, 0.0f});
            refuses(mesh.what(), suffix, QStringLiteral("Vertex 2 is farther from the origin"));
        }
    }

    void dentsInwardsAreWritten_data() { formats(); }
    void dentsInwardsAreWritten() {
        QFETCH(QString, suffix);
        for (const QString& source : {m_obj, m_ply}) {
            DentedFile mesh(source);
            mesh.move(2, {-0.25f, -0.125f, 0.25f});
            const QString path = out(suffix);
            const Result<QStringList> written = write(mesh.what(), path);
            QVERIFY2(written, qPrintable(messageOf(written)));
            const Status same = verifyWritten(path, mesh.what());
            QVERIFY2(same, qPrintable(messageOf(same)));
            if (suffix != QStringLiteral("stl")) {
                QVERIFY(readFile(path).find("inf") == std::string::npos);
            }
        }
    }

    /// From one edge to the other: both are floats, what is between them is none.
    void farMovesAreRefusedWhereTheyAreWritten_data() { formats(); }
    void farMovesAreRefusedWhereTheyAreWritten() {
        QFETCH(QString, suffix);
        DentedFile mesh(m_obj);
        mesh.move(0, {0.75f, 0.0f, 0.0f});
        if (holdsDisplacements(suffix)) {
            refuses(mesh.what(), suffix, QStringLiteral("Vertex 1 moved farther"));
        } else {
            const Result<QStringList> written = write(mesh.what(), out(suffix));
            QVERIFY2(written, qPrintable(messageOf(written)));
            QVERIFY(verifyWritten(out(suffix), mesh.what()));
        }
    }

    void stepsBeyondFloatsAreRefused() {
        DentedFile mesh(m_obj);
        mesh.move(2, {-0.25f, 0.0f, 0.0f});
        MeshExport what = mesh.what();
        const glm::vec3 outside = mesh.original.mesh.positions[2] + glm::vec3(0.01f, 0.0f, 0.0f);
        what.steps = {{"Hit 1", {{2, outside}}}, {"Hit 2", {{2, mesh.positions[2]}}}};
        refuses(what, QStringLiteral("glb"), QStringLiteral("Vertex 3 is farther from the origin"));
        const glm::vec3 across = mesh.original.mesh.positions[2] - glm::vec3(0.75f, 0.0f, 0.0f);
        what.steps = {{"Hit 1", {{2, across}}}, {"Hit 2", {{2, mesh.positions[2]}}}};
        refuses(what, QStringLiteral("glb"), QStringLiteral("Vertex 3 moved farther"));
    }

    void whatIsNoNumberIsRefused_data() { formats(); }
    void whatIsNoNumberIsRefused() {
        QFETCH(QString, suffix);
        DentedFile mesh(writeFile(m_folder->path(), QStringLiteral("small.obj"),
                                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
        for (const float bad :
             {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
              std::numeric_limits<float>::quiet_NaN()}) {
            mesh.positions[3].y = bad;
            refuses(mesh.what(), suffix, QStringLiteral("Vertex 4 is"));
        }
    }

private:
    static void formats() {
        QTest::addColumn<QString>("suffix");
        for (const char* const suffix : {"obj", "ply", "stl", "glb", "gltf", "csv"}) {
            QTest::newRow(suffix) << QString::fromLatin1(suffix);
        }
    }
    [[nodiscard]] QString out(const QString& suffix) const {
        return m_folder->filePath(QStringLiteral("out.") + suffix);
    }
    /// Says so, and writes nothing.
    void refuses(const MeshExport& what, const QString& suffix, const QString& says) const {
        const QStringList before = QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden);
        const Result<QStringList> written = write(what, out(suffix));
        QVERIFY(!written);
        QVERIFY2(messageOf(written).startsWith(out(suffix) + QStringLiteral(": ") + says),
                 qPrintable(messageOf(written)));
        QVERIFY(messageOf(written).contains(QStringLiteral("coordinates of the scene")));
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden), before);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_obj;
    QString m_ply;
};

HITSCOPE_TEST(TestIoHugeExport, QCoreApplication)

}  // namespace hitscope::io_huge_export_test

#include "io_huge_export_test.moc"
