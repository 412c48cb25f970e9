// SPDX-License-Identifier: GPL-3.0-or-later
// What an OBJ file says, however it is cut into parts that are read at once, and whatever its numbers and
// names look like.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "io/mesh_stream.h"
#include "io/readers/obj_reader.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_obj_parts_test {

using namespace test;

namespace {

/// Vertices, faces and all that carries on from one line to the next, in a few hundred lines.
std::string longText() {
    std::string text = "# a comment\nmtllib a.mtl\n";
    for (int v = 0; v < 700; ++v) {
        const std::string n = std::to_string(v);
        text += v % 5 == 0 ? "v " + n + " 0.5 \\\n -1.25\n" : "v " + n + ".125 1e-3 " + n + "\n";
        text += v >= 40 && v < 50 ? "v 1 2 " + n + " 0.25 0.5 1\n" : "";
        text += "vt 0." + n + " 0.5\nvn 0 " + n + " 1\n";
        if (v % 50 == 20) {
            text += (v % 100 == 20 ? "g part " : "o whole ") + n + "\n";
        }
        text += v % 170 == 30 ? "usemtl paint " + std::to_string(v % 3) + "\n" : "";
        text += v == 410 ? "usemtl\n" : "";
        text += v % 130 == 60 ? "s " + std::to_string(v % 4) + "\n" : "";
        if (v > 3) {
            const std::string c = std::to_string(v - 2);
            text += "f " + c + "/" + c + "/1 " + n + "//2 1/2 " + (v % 3 == 0 ? "705\n" : "2\n");
        }
        text += v % 60 == 7 ? "# C:\\parts\\\n" : "";
        text += v % 90 == 10 ? "l 1 2 3\np 4\nf 1 2\n" : "";
    }
    return text;
}

Result<ImportedMesh> inParts(const std::string& text, std::size_t parts) {
    return parseObjInParts(text, parts);
}

}  // namespace

class ObjPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void comeToTheSameMesh_data();
    void comeToTheSameMesh();
    void comeToTheSameError_data();
    void comeToTheSameError();
    void numbersMayBeLong_data();
    void numbersMayBeLong();
    void namesMayHaveAnyBytes();
    void keepsTheShapeFarFromTheOrigin();
    void keepsThePlaceOfWhatIsNear();
};

void ObjPartsTest::comeToTheSameMesh_data() {
    QTest::addColumn<QString>("text");
    const QString text = QString::fromStdString(longText());
    QTest::addRow("much of everything") << text;
    QTest::addRow("counted from the end") << text + "f -1/-1/-1 -2 -3\nv 1 1 1\n";
    QTest::addRow("no line end") << text + "v 1 2 3";
    QTest::addRow("line ends of Windows") << QString(text).replace('\n', "\r\n");
    QTest::addRow("line ends of all kinds") << text + "v 0 0 0\rv 1 1 1\n" +
                                                   QString(text).replace('\n', "\r\n") +
                                                   QString(text).replace('\n', '\r');
    QTest::addRow("few lines") << QStringLiteral("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::addRow("one line") << QStringLiteral("v 0 0 0");
}

void ObjPartsTest::comeToTheSameMesh() {
    QFETCH(QString, text);
    const std::string bytes = text.toStdString();
    const Result<ImportedMesh> whole = inParts(bytes, 1);
    QVERIFY(whole.ok());
    for (std::size_t parts = 2; parts <= 9; ++parts) {
        const Result<ImportedMesh> cut = inParts(bytes, parts);
        QVERIFY(cut.ok());
        QCOMPARE(differences(cut.value().mesh, whole.value().mesh), QStringList());
        QCOMPARE(cut.value().notes, whole.value().notes);
    }
}

void ObjPartsTest::comeToTheSameError_data() {
    QTest::addColumn<QString>("line");
    QTest::addRow("a word") << "v 1 two 3\n";
    QTest::addRow("a vertex that never comes") << "f 1 2 99999\nf 1 2 99998\n";
    QTest::addRow("before the first") << "f 1 2 -99999\n";
    QTest::addRow("cut off") << "f 1 2";
}

void ObjPartsTest::comeToTheSameError() {
    QFETCH(QString, line);
    for (const bool late : {false, true}) {
        const std::string bytes =
            late ? longText() + line.toStdString() + (line.endsWith('\n') ? longText() : std::string())
                 : line.toStdString() + "\n" + longText();
        const Result<ImportedMesh> whole = inParts(bytes, 1);
        for (std::size_t parts = 2; parts <= 5; ++parts) {
            const Result<ImportedMesh> cut = inParts(bytes, parts);
            QCOMPARE(cut.ok(), whole.ok());
            QVERIFY(cut.ok() || cut.error().message() == whole.error().message());
        }
        QVERIFY(!whole.ok() || (!late && !line.endsWith('\n')));
    }
}

void ObjPartsTest::numbersMayBeLong_data() {
    QTest::addColumn<QByteArray>("number");
    QTest::addColumn<double>("value");
    const QByteArray zeros(400, '0');
    QTest::addRow("small, with zeros") << QByteArray("0." + zeros + "1") << 0.0;
    QTest::addRow("small, with zeros and an exponent") << QByteArray("0." + zeros + "25e401") << 2.5;
    QTest::addRow("negative and small") << QByteArray("-." + zeros + "1") << -0.0;
    QTest::addRow("large, with an exponent down") << QByteArray("25" + zeros + "e-401") << 2.5;
    QTest::addRow("more digits than a double has") << QByteArray("1.5" + zeros + "1") << 1.5;
    QTest::addRow("leading zeros") << QByteArray(zeros + "3.5") << 3.5;
    QTest::addRow("zero with an exponent") << QByteArray("0." + zeros + "e400") << 0.0;
    QTest::addRow("an exponent that is no number of ours") << QByteArray("1e-99999999999999999999") << 0.0;
}

void ObjPartsTest::numbersMayBeLong() {
    QFETCH(QByteArray, number);
    QFETCH(double, value);
    const Result<ImportedMesh> read =
        parseObj("v " + number.toStdString() + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
    QCOMPARE(double{read.value().mesh.positions[0].x}, value);
    QCOMPARE(std::signbit(read.value().mesh.positions[0].x), std::signbit(value));
    for (const std::string& tooLarge : {"1" + std::string(400, '0'), std::string("1e999999999999999999999"),
                                        "0." + std::string(400, '0') + "1e999"}) {
        QVERIFY(!parseObj("v " + tooLarge + " 0 0\n").ok());
    }
}

void ObjPartsTest::namesMayHaveAnyBytes() {
    std::string any;
    for (int byte = 1; byte < 256; ++byte) {
        any += byte == '\n' ? ' ' : static_cast<char>(byte);
    }
    const std::string name = "\xff\xfe" + any + std::string(1, '\0') + std::string(100'000, '\x80') + "!";
    const std::string text =
        "o " + name + "\ng " + name + "\nusemtl " + name + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n";
    const Result<ImportedMesh> read = parseObj(text);
    QVERIFY(read.ok());
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mesh"));
    QVERIFY(writeMeshStream(read.value().mesh, path).ok());
    const MeshData mesh = readMeshStream(path).value();
    QCOMPARE(mesh.groups.size(), std::size_t(2));
    QCOMPARE(mesh.groups[0].name, name);
    QCOMPARE(mesh.groups[1].name, name);
    QCOMPARE(mesh.materials[0].name, name);
}

void ObjPartsTest::keepsTheShapeFarFromTheOrigin() {
    const Result<ImportedMesh> read =
        parseObj("v 10000000.001 0 500\nv 10000000.003 0 500\nv 10000000.001 0.002 500\nf 1 2 3\n");
    QVERIFY(read.ok());
    const MeshData& mesh = read.value().mesh;
    QCOMPARE(read.value().notes.size(), 1);
    QCOMPARE(mesh.filePositions[1], glm::dvec3(10000000.003, 0, 500));
    QVERIFY(!mesh.placement.isIdentity());
    const glm::vec3 along = mesh.positions[1] - mesh.positions[0];
    QVERIFY(std::abs(along.x - 0.002f) < 1e-8f);
    QCOMPARE(mesh.positions[2].y, 0.002f);
    // What moves is written from its local place.
    const glm::dvec3 back = glm::dvec3(mesh.positions[1]) / mesh.placement.scale + mesh.placement.centre;
    QVERIFY(std::abs(back.x - 10000000.003) < 1e-8);
    QVERIFY(validate(mesh).ok());
}

void ObjPartsTest::keepsThePlaceOfWhatIsNear() {
    const MeshData mesh = parseObj("v 100.1 0 0\nv 102.1 0 0\nv 100.1 2 0\nf 1 2 3\n").value().mesh;
    QVERIFY(mesh.placement.isIdentity());
    QCOMPARE(mesh.positions[0].x, 100.1f);
}

HITSCOPE_TEST(ObjPartsTest, QCoreApplication)

}  // namespace hitscope::io_obj_parts_test

#include "io_obj_parts_test.moc"
