// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <bit>
#include <cmath>
#include <random>

#include "export_support.h"
#include "io/export_obj.h"
#include "io/readers/obj_reader.h"
#include "io/writers/normal_plan.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_export_test {

using namespace test;

namespace {

std::vector<glm::vec3> normalsOfCorners(const MeshData& mesh, const glm::vec3& otherwise) {
    std::vector<glm::vec3> normals(mesh.cornerVertices.size(), otherwise);
    for (std::size_t c = 0; c < mesh.cornerNormals.size(); ++c) {
        if (mesh.cornerNormals[c] != kNoIndex) {
            normals[c] = mesh.normals[mesh.cornerNormals[c]];
        }
    }
    return normals;
}

}  // namespace

class ExportTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void givesBackWhatWasRead();
    void givesBackNormalsThatAreAllGiven();
    void keepsColours();
    void keepsEveryFloat();
    void writesTheFilesOwnNumbers();
    void undoesThePlacement();
    void writesEachNormalOnce();
    void keepsFileNormalsButForTheirLength();
    void makesNamesUsable();

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void ExportTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("source/maps")));
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("target")));
}

void ExportTest::givesBackWhatWasRead() {
    const ImportedMesh original = read(writeRich(in("source")));
    QCOMPARE(original.mesh.faceCount(), std::size_t(5));
    // No normals: all else is the same.
    MeshData bare = original.mesh;
    bare.normals.clear();
    bare.cornerNormals.clear();
    ObjExport what = exportOf(bare, bare.positions);
    what.sourceFolder = in("source");
    QVERIFY2(exportObj(what, in("source/again.obj")).ok(), "export");
    const ImportedMesh again = read(in("source/again.obj"));
    QCOMPARE(differences(again.mesh, bare), QStringList());
    // The source's own library serves; no other is made beside it.
    QCOMPARE(again.mesh.materialLibraries, std::vector<std::string>{"rich.mtl"});
    QCOMPARE(readFile(in("source/rich.mtl")), std::string(kRichMtl));
    QVERIFY(!QFile::exists(in("source/again.mtl")));
}

void ExportTest::givesBackNormalsThatAreAllGiven() {
    const char* const text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 5 5 5\nvn 0 0 2\nvn 0 1 0\nf 1//4 2//3 3//1\nf 3//1 2//3 "
        "1//4\n";
    const MeshData mesh = parseObj(text).value().mesh;
    const std::vector<glm::vec3> normals = normalsOfCorners(mesh, {});
    ObjExport what = exportOf(mesh, mesh.positions);
    what.normals = {normals, {}};
    const Result<ImportedMesh> again = parseObj(formatObj(what, {}));
    QVERIFY2(again.ok(), qPrintable(messageOf(again)));
    QCOMPARE(differences(again.value().mesh, mesh), QStringList());
}

void ExportTest::keepsColours() {
    const MeshData mesh =
        parseObj("v 0 0 0 0.1 0.2 0.3\nv 1 0 0 0 0 1\nv 0 1 0 1 1 1\nf 1 2 3\n").value().mesh;
    const MeshData again = parseObj(formatObj(exportOf(mesh, mesh.positions), {})).value().mesh;
    QCOMPARE(differences(again, mesh), QStringList());
}

void ExportTest::keepsEveryFloat() {
    std::mt19937 random(99);
    MeshData mesh;
    mesh.positions.resize(40000);
    std::vector<glm::vec3> moved;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::vec3 position;
        for (int i = 0; i < 3; ++i) {
            do {
                position[i] = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            } while (!std::isfinite(position[i]));
        }
        moved.push_back(position);
    }
    moved[0].x =
        std::bit_cast<float>(0x15ae43fdu);  // its shortest text is rounded wrongly by way of a double
    const MeshData again = parseObj(formatObj(exportOf(mesh, moved), {})).value().mesh;
    QCOMPARE(again.filePositions.size(), moved.size());
    for (std::size_t v = 0; v < moved.size(); ++v) {
        for (int i = 0; i < 3; ++i) {
            // So large a mesh is placed: its file's numbers are beside.
            QCOMPARE(std::bit_cast<std::uint32_t>(static_cast<float>(again.filePositions[v][i])),
                     std::bit_cast<std::uint32_t>(moved[v][i]));
        }
    }
}

void ExportTest::writesTheFilesOwnNumbers() {
    const MeshData mesh =
        parseObj("v 0.1 123456.789012345 1e-300\nv 1 0 0\nv 0 0.7 0\nf 1 2 3\n").value().mesh;
    PageVector<glm::vec3> positions = mesh.positions;
    positions[2] = {0.25f, 0.1f, -3.0f};
    const QString text = QString::fromStdString(formatObj(exportOf(mesh, positions), {"a.mtl"}));
    QVERIFY2(text.contains(QStringLiteral("\nv 0.1 123456.789012345 1e-300\nv 1 0 0\nv 0.25 0.1 -3\n")),
             qPrintable(text));
    QVERIFY(text.contains(QStringLiteral("\nmtllib a.mtl\n")));
}

void ExportTest::undoesThePlacement() {
    MeshData mesh = parseObj("v 100.1 0 0\nv 104.1 0 0\nv 100.1 2 0\nf 1 2 3\n").value().mesh;
    place(mesh, 1.0f);
    PageVector<glm::vec3> positions = mesh.positions;
    positions[1].y += 0.25f;  // a quarter of a unit here is one in the file
    const MeshData again = parseObj(formatObj(exportOf(mesh, positions), {})).value().mesh;
    QVERIFY(again.filePositions.at(0) == glm::dvec3(100.1, 0, 0));
    QVERIFY(again.filePositions.at(2) == glm::dvec3(100.1, 2, 0));
    QVERIFY(glm::distance(again.filePositions.at(1), glm::dvec3(104.1, 1, 0)) < 1e-6);
}

void ExportTest::writesEachNormalOnce() {
    const MeshData mesh =
        parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1 2 3\n").value().mesh;
    std::vector<glm::vec3> normals(6, glm::vec3(0, 0, 1));
    normals[4] = {0, 1, 0};
    ObjExport what = exportOf(mesh, mesh.positions);
    what.normals = {normals, {}};
    const MeshData again = parseObj(formatObj(what, {})).value().mesh;
    // The file's own is used no longer, and goes.
    QCOMPARE(again.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}}));
    QCOMPARE(again.cornerNormals, (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 0}));
}

void ExportTest::keepsFileNormalsButForTheirLength() {
    const MeshData mesh = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 2 3\nf 1//1 2//1 3//1\n").value().mesh;
    const std::vector<glm::vec3> normals{glm::normalize(glm::vec3(1, 2, 3)),
                                         glm::normalize(glm::vec3(1, 2, 3)),
                                         glm::normalize(glm::vec3(1, 2, 3.1f))};
    ObjExport what = exportOf(mesh, mesh.positions);
    what.normals = {normals, {}};
    const MeshData again = parseObj(formatObj(what, {})).value().mesh;
    QCOMPARE(again.normals.size(), std::size_t{2});
    QCOMPARE(again.normals[0], glm::vec3(1, 2, 3));
    QVERIFY(isSameDirection(again.normals[1], normals[2]));  // with six decimals
    QCOMPARE(again.cornerNormals, (std::vector<std::uint32_t>{0, 0, 1}));
}

void ExportTest::makesNamesUsable() {
    MeshData mesh = parseObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\nf 1 2 3\n").value().mesh;
    mesh.materials.resize(3);
    mesh.materials[0].name = "a\nf 9 9 9";
    mesh.materials[2].name = "a f 9 9 9";
    mesh.faceMaterials = {0, 1, 2};
    mesh.groups = {{FaceGroup::Kind::Group, " tab\tand\\", 0}};
    QVERIFY(exportObj(exportOf(mesh, mesh.positions), in("target/my mesh.obj")).ok());
    const ImportedMesh again = read(in("target/my mesh.obj"));
    QCOMPARE(again.notes, QStringList());
    QCOMPARE(again.mesh.faceMaterials, mesh.faceMaterials);
    QCOMPARE(again.mesh.materials[0].name, std::string("a f 9 9 9"));
    QCOMPARE(again.mesh.materials[1].name, std::string("material_2"));
    QCOMPARE(again.mesh.materials[2].name, std::string("a f 9 9 9_2"));
    QCOMPARE(again.mesh.groups[0].name, std::string("tab and/"));
    QVERIFY(QFile::exists(in("target/my_mesh.mtl")));
}

HITSCOPE_TEST(ExportTest, QCoreApplication)

}  // namespace hitscope::io_export_test

#include "io_export_test.moc"
