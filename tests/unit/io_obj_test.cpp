// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <numeric>

#include "io/readers/obj_reader.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_obj_test {

using namespace test;
using Indices = std::vector<std::uint32_t>;

namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

MeshData parsed(const std::string& text) {
    const Result<ImportedMesh> result = parseObj(text);
    if (!result) {
        qWarning("%s", result.error().message().c_str());
        return {};
    }
    return result.value().mesh;
}

QStringList notesOf(const std::string& text) {
    const Result<ImportedMesh> result = parseObj(text);
    return result ? result.value().notes : QStringList{QStringLiteral("no mesh")};
}

}  // namespace

class ObjTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void keepsTheFilesOrder();
    void keepsTheFilesNumbers();
    void keepsPolygonsOfAnySize();
    void keepsGroupsMaterialsAndSmoothing();
    void keepsLinesPointsAndColours();
    void understandsEveryWayToWriteCorners();
    void understandsLineEnds_data();
    void understandsLineEnds();
    void leavesOutWithANote_data();
    void leavesOutWithANote();
    void refuses_data();
    void refuses();
};

void ObjTest::keepsTheFilesOrder() {
    const MeshData mesh = parsed("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 8 8 8\nf 4 2 3\n");
    QCOMPARE(mesh.vertexCount(), std::size_t(5));  // the two that no face uses are among them
    QCOMPARE(mesh.positions[0], glm::vec3(9, 9, 9));
    QCOMPARE(mesh.positions[4], glm::vec3(8, 8, 8));
    QCOMPARE(mesh.cornerVertices, (Indices{3, 1, 2}));
    QVERIFY(validate(mesh).ok());
}

void ObjTest::keepsTheFilesNumbers() {
    const MeshData mesh = parsed("v 0.1 +2.5 -1e-3\nv 123456.789012345 .5 5.\nv 1 2 3\nf 1 2 3\n");
    QCOMPARE(mesh.filePositions.size(), std::size_t(3));
    QVERIFY(mesh.filePositions[0] == glm::dvec3(0.1, 2.5, -1e-3));
    QVERIFY(mesh.filePositions[1] == glm::dvec3(123456.789012345, 0.5, 5.0));
    QCOMPARE(mesh.positions[0], glm::vec3(0.1f, 2.5f, -1e-3f));
    // Numbers that floats hold exactly need no second copy.
    QVERIFY(parsed(std::string(kTriangle) + "f 1 2 3\n").filePositions.empty());
}

void ObjTest::keepsPolygonsOfAnySize() {
    std::string text;
    std::string face = "f";
    for (int i = 1; i <= 300; ++i) {
        text += "v " + std::to_string(i) + " 0 0\n";
        face += ' ' + std::to_string(i);
    }
    const MeshData mesh = parsed(text + face + "\nf 1 2 3 4\n");
    QCOMPARE(mesh.faceStarts, (Indices{0, 300, 304}));
    Indices expected(300);
    std::iota(expected.begin(), expected.end(), 0u);
    QVERIFY(std::equal(expected.begin(), expected.end(), mesh.face(0).begin()));
}

void ObjTest::keepsGroupsMaterialsAndSmoothing() {
    const MeshData mesh =
        parsed(std::string(kTriangle) +
               "mtllib my scene.mtl\no the body\ng left arm\nusemtl shiny red\ns 3\nf 1 2 3\n"
               "usemtl blue\ns off\nf 1 2 3\nusemtl shiny red\nf 1 2 3\ng empty\no tail\ns on\n");
    QCOMPARE(mesh.materialLibraries, std::vector<std::string>{"my scene.mtl"});
    QCOMPARE(mesh.groups.size(), std::size_t(4));
    QCOMPARE(mesh.groups[0].kind, FaceGroup::Kind::Object);
    QCOMPARE(mesh.groups[0].name, std::string("the body"));
    QCOMPARE(mesh.groups[1].kind, FaceGroup::Kind::Group);
    QCOMPARE(mesh.groups[1].name, std::string("left arm"));
    QCOMPARE(mesh.groups[3].name, std::string("tail"));
    QCOMPARE(mesh.groups[3].firstFace, 3u);
    QCOMPARE(mesh.materials.size(), std::size_t(2));
    QCOMPARE(mesh.materials[0].name, std::string("shiny red"));
    QCOMPARE(mesh.faceMaterials, (Indices{0, 1, 0}));
    QCOMPARE(mesh.faceSmoothing, (Indices{3, 0, 0}));
    QVERIFY(validate(mesh).ok());
}

void ObjTest::keepsLinesPointsAndColours() {
    const MeshData mesh =
        parsed("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 0\nv 0 1 0\nf 1 2 3\nl 1/1 2/2 3/3\nl 3 1\np 2\np 1 -1\n");
    QCOMPARE(mesh.lines, (std::vector<Indices>{{0, 1, 2}, {2, 0}}));
    QCOMPARE(mesh.points, (Indices{1, 0, 2}));
    QCOMPARE(mesh.colours, (std::vector<glm::vec3>{{1, 0.5f, 0}, {0, 0, 0}, {1, 1, 1}}));
    const MeshData bytes = parsed("v 0 0 0 255 0 0\nv 1 0 0 0 51 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
    QCOMPARE(bytes.colours[1], glm::vec3(0, 0.2f, 0));
}

void ObjTest::understandsEveryWayToWriteCorners() {
    const MeshData mesh =
        parsed(std::string(kTriangle) +
               "vt 0.25 0.75\nvt 1\nvt 0 0 0\nvn 0 0 1\nvn 0 0 -1\n"
               "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//2 3//1\nf -3/-3/-2 -2/-2/-1 -1/-1/-1 # comment\n"
               "f 1/ 2/ 3/\n");
    QCOMPARE(mesh.faceCount(), std::size_t(5));
    QCOMPARE(mesh.texcoords[1], glm::vec2(1, 0));
    const auto n = kNoIndex;
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}));
    QCOMPARE(mesh.cornerTexcoords, (Indices{n, n, n, 0, 1, 2, n, n, n, 0, 1, 2, n, n, n}));
    QCOMPARE(mesh.cornerNormals, (Indices{n, n, n, n, n, n, 0, 1, 0, 0, 1, 1, n, n, n}));
    // A face may come before its vertices when it counts from the start.
    QCOMPARE(parsed("f 1 2 3\n" + std::string(kTriangle)).cornerVertices, (Indices{0, 1, 2}));
}

void ObjTest::understandsLineEnds_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("unix") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("dos") << QByteArray("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n");
    QTest::newRow("old mac") << QByteArray("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r");
    QTest::newRow("no last end") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
    QTest::newRow("blanks") << QByteArray("\n  v 0\t0 0  \n\n v 1 0 0 \nv 0 1 0\t\nf  1  2  3 \n \n");
    QTest::newRow("continued") << QByteArray("v 0 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 \\\r\n2 \\\n3\n");
    QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("folders in comments") << QByteArray(
        "# C:\\models\\\r\nv 0 0 0\r\n \t# C:\\ \r\nv 1 0 0\r\nv 0 1 \\\n0\r\n#\\\r\nf 1 2 3\r\n# \\");
    QTest::newRow("returns that hide nothing")
        << QByteArray("# a\r# b\rby hand\nv 0 0 0 \r\r\n\rv 1 0 0 # c\n\rv 0 1 0\n\rg a\n\rf 1 2 3\r# d\n");
    QTest::newRow("hidden vertex") << QByteArray("v 0 0 0\rv 1 0 0\nv 0 1 0\rf 1 2 3\n");
    QTest::newRow("hidden by a comment") << QByteArray("# a\r# b\rv 0 0 0\rv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("all but the last") << QByteArray("\rv 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r\n");
    QTest::newRow("all kinds, continued")
        << QByteArray("v 0 0 \\\r 0\rv 1 0 0\r\nv 0 1 0\nusemtl a\rf 1 \\\r\n2 \\\n3\rg b");
    QTest::newRow("comments") << QByteArray("# v 5 5 5\nv 0 0 0 # first\nv 1 0 0\nv 0 1 0\nf 1 2 3 #4\n");
}

void ObjTest::understandsLineEnds() {
    QFETCH(QByteArray, text);
    const MeshData mesh = parsed(text.toStdString());
    QCOMPARE(mesh.positions, (PageVector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2}));
}

void ObjTest::leavesOutWithANote_data() {
    QTest::addColumn<QString>("lines");
    QTest::addColumn<QString>("note");
    QTest::newRow("two corners") << "f 1 2\n"
                                 << "1 face with fewer than three corners";
    QTest::newRow("no corners") << "f\nf 1\n"
                                << "2 faces with fewer than three corners";
    QTest::newRow("line of one") << "l 1\n"
                                 << "1 line with fewer than two";
    QTest::newRow("free form") << "surf 0 1 0 1 1 2 3\n"
                               << "1 free-form";
    QTest::newRow("texcoord index") << "vt 0 0\nf 1/1 2/7 3/1\n"
                                    << "1 face corner refers to texture coordinates";
    QTest::newRow("texcoord nan") << "vt nan 0\nf 1/1 2/1 3/1\n"
                                  << "3 face corners refer to texture coordinates";
    QTest::newRow("normal index") << "vn 0 0 1\nf 1//1 2//-2 3//1\n"
                                  << "1 face corner refers to a normal";
}

void ObjTest::leavesOutWithANote() {
    QFETCH(QString, lines);
    QFETCH(QString, note);
    const std::string text = kTriangle + std::string("f 1 2 3\n") + lines.toStdString();
    QCOMPARE(notesOf(text).size(), 1);
    QVERIFY2(notesOf(text).at(0).contains(note), qPrintable(notesOf(text).at(0)));
    const MeshData mesh = parsed(text);
    QVERIFY(validate(mesh).ok());
    QVERIFY(mesh.faceCount() >= 1);
}

void ObjTest::refuses_data() {
    QTest::addColumn<QString>("lines");
    QTest::addColumn<QString>("message");
    QTest::newRow("index too large") << "f 1 2 12\n"
                                     << "line 4: The face refers to vertex 12, but the file has only 3.";
    QTest::newRow("index too negative") << "f 1 2 -4\n"
                                        << "line 4: The face refers to vertex -4, but there are only 3";
    QTest::newRow("index zero") << "\nf 0 1 2\n"
                                << "line 5: The face refers to vertex 0, but OBJ files count from 1.";
    QTest::newRow("index huge") << "f 1 2 99999999999999999999\n"
                                << "line 4: The face refers to vertex";
    QTest::newRow("no index") << "f 1 2 three\n"
                              << "line 4: \"three\" is not a corner of a face.";
    QTest::newRow("broken corner") << "f 1 2 3/1x\n"
                                   << "\"3/1x\" is not a corner";
    QTest::newRow("nan") << "v nan 0 0\n"
                         << "line 4: A coordinate is not a number";
    QTest::newRow("infinite") << "v 0 -inf 0\n"
                              << "line 4: A coordinate is not a number, infinite";
    QTest::newRow("too large") << "v 0 0 1e39\n"
                               << "line 4: A coordinate is not a number, infinite or too large.";
    QTest::newRow("far too large") << "v 0 0 1e999\n"
                                   << "line 4: A coordinate is not a number";
    QTest::newRow("word") << "v 0 0 x\n"
                          << "line 4: \"x\" is not a number.";
    QTest::newRow("two numbers") << "v 0 0\n"
                                 << "line 4: The vertex has too few numbers.";
    QTest::newRow("line index") << "l 1 9\n"
                                << "vertex 9, but the file has only 3";
    QTest::newRow("point index") << "p 0\n"
                                 << "The point refers to vertex 0";
    QTest::newRow("cut face") << "f 1 2"
                              << "The file ends";
    QTest::newRow("cut vertex") << "v 1 2"
                                << "The file ends there, in the middle of a line.";
    QTest::newRow("behind other line ends") << "v 0 0 0\rv 1 x 0\n"
                                            << "line 5: \"x\" is not a number.";
    QTest::newRow("after continued") << "v 0 \\\n 0 0\nv 1\n"
                                     << "line 6: ";
}

void ObjTest::refuses() {
    QFETCH(QString, lines);
    QFETCH(QString, message);
    const Result<ImportedMesh> result = parseObj(kTriangle + lines.toStdString());
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
}

HITSCOPE_TEST(ObjTest, QCoreApplication)

}  // namespace hitscope::io_obj_test

#include "io_obj_test.moc"
