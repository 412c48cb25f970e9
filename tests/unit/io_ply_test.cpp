// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>

#include "io/readers/ply_reader.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_ply_test {

using namespace test;
using Indices = std::vector<std::uint32_t>;

namespace {

/// A number as it stands in a binary file of either byte order.
template <class Number>
void append(std::string& bytes, Number number, bool big) {
    std::string one;
    put(one, number);
    if (big) {
        std::reverse(one.begin(), one.end());
    }
    bytes += one;
}

/// A quad and a triangle with everything a vertex can have, and things to skip before, between and behind.
std::string binaryPly(bool big) {
    std::string file =
        "ply\nformat binary_" + std::string(big ? "big" : "little") +
        "_endian 1.0\ncomment made by a test\nobj_info nothing\nCreated by a program\n"
        "element camera 1\nproperty double zoom\nproperty list uchar short rows\n"
        "element vertex 4\nproperty double x\nproperty float y\nproperty short z\n"
        "property list ushort int neighbours\nproperty float nx\nproperty float ny\n"
        "property float nz\nproperty float s\nproperty float t\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
        "element face 2\nproperty uchar flags\nproperty list uchar uint vertex_indices\n"
        "property int tail\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    append(file, 2.0, big);
    append(file, std::uint8_t{2}, big);
    append(file, std::int16_t{7}, big);
    append(file, std::int16_t{8}, big);
    for (int v = 0; v < 4; ++v) {
        append(file, v == 1 || v == 2 ? 0.1 : 0.0, big);
        append(file, v >= 2 ? 1.5f : 0.0f, big);
        append(file, static_cast<std::int16_t>(-v), big);
        append(file, static_cast<std::uint16_t>(v), big);
        for (int i = 0; i < v; ++i) {
            append(file, std::int32_t{-5}, big);
        }
        for (const float number : {0.0f, 0.0f, 1.0f, 0.25f * static_cast<float>(v), 0.5f}) {
            append(file, number, big);
        }
        for (const int colour : {255, 51 * v, 0, 9}) {
            append(file, static_cast<std::uint8_t>(colour), big);
        }
    }
    for (const Indices& face : {Indices{0, 1, 2, 3}, Indices{2, 3, 0}}) {
        append(file, std::uint8_t{1}, big);
        append(file, static_cast<std::uint8_t>(face.size()), big);
        for (const std::uint32_t vertex : face) {
            append(file, vertex, big);
        }
        append(file, std::int32_t{-1}, big);
    }
    append(file, std::int32_t{0}, big);
    append(file, std::int32_t{1}, big);
    return file;
}

const char* const kAscii =
    "ply\r\nformat ascii 1.0\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\nproperty float "
    "z\r\n"
    "element face 2\r\nproperty list uchar int vertex_index\r\nend_header\r\n"
    "0 0 0\r\n0.1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3\r\n3 2 3 0\r\n";

std::string asciiPly(const std::string& vertices, const std::string& faces, const std::string& data) {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n" + data;
}

}  // namespace

class PlyTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void readsAscii();
    void readsBinary_data();
    void readsBinary();
    void readsStrips();
    void readsBinaryStrips();
    void readsColoursOfAnyType_data();
    void readsColoursOfAnyType();
    void readsFaceTexcoords();
    void leavesOutSmallFaces();
    void notesWhatFollows();
    void refuses_data();
    void refuses();
    void refusesEveryTruncation();
};

void PlyTest::readsAscii() {
    const Result<ImportedMesh> result = parsePly(kAscii);
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    const MeshData& mesh = result.value().mesh;
    QCOMPARE(mesh.positions[1], glm::vec3(0.1f, 0, 0));
    QVERIFY(mesh.filePositions[1] == glm::dvec3(0.1, 0, 0));
    QCOMPARE(mesh.faceStarts, (Indices{0, 4, 7}));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 3, 2, 3, 0}));
    QVERIFY(mesh.normals.empty() && mesh.colours.empty() && mesh.texcoords.empty());
}

void PlyTest::readsBinary_data() {
    QTest::addColumn<bool>("big");
    QTest::newRow("little endian") << false;
    QTest::newRow("big endian") << true;
}

void PlyTest::readsBinary() {
    QFETCH(bool, big);
    const Result<ImportedMesh> result = parsePly(binaryPly(big));
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    const MeshData& mesh = result.value().mesh;
    QVERIFY(validate(mesh).ok());
    QCOMPARE(mesh.vertexCount(), std::size_t(4));
    QVERIFY(mesh.filePositions[2] == glm::dvec3(0.1, 1.5, -2));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 3, 2, 3, 0}));
    QCOMPARE(mesh.cornerNormals, mesh.cornerVertices);
    QCOMPARE(mesh.normals[3], glm::vec3(0, 0, 1));
    QCOMPARE(mesh.cornerTexcoords, mesh.cornerVertices);
    QCOMPARE(mesh.texcoords[3], glm::vec2(0.75f, 0.5f));
    QCOMPARE(mesh.colours[1], glm::vec3(1, 0.2f, 0));
}

void PlyTest::readsStrips() {
    const Result<ImportedMesh> result = parsePly(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0\n13 0 1 2 3 -1 2 3 4 5 -1 1 1 2\n");
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    // Every second triangle turned, the winding starting anew after -1, and no triangle of two vertices.
    QCOMPARE(result.value().mesh.cornerVertices, (Indices{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5}));
}

void PlyTest::readsBinaryStrips() {
    for (const bool big : {false, true}) {
        std::string file = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                           "_endian 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                           "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                           "end_header\n";
        for (int v = 0; v < 5; ++v) {
            for (const int coordinate : {v / 2, v % 2, 0}) {
                append(file, static_cast<float>(coordinate), big);
            }
        }
        append(file, std::int32_t{8}, big);
        for (const std::int32_t index : {0, 1, 2, 3, -1, 2, 3, 4}) {
            append(file, index, big);
        }
        const Result<ImportedMesh> read = parsePly(file);
        QVERIFY2(read.ok(), qPrintable(messageOf(read)));
        QCOMPARE(read.value().mesh.cornerVertices, (Indices{0, 1, 2, 2, 1, 3, 2, 3, 4}));
    }
}

void PlyTest::readsColoursOfAnyType_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("prefix");
    QTest::addColumn<QString>("colour");
    QTest::addRow("bytes") << "uchar"
                           << ""
                           << "255 0 51";
    QTest::addRow("diffuse bytes") << "uint8"
                                   << "diffuse_"
                                   << "255 0 51";
    QTest::addRow("floats") << "float"
                            << ""
                            << "1 0 0.2";
    QTest::addRow("diffuse floats") << "float32"
                                    << "diffuse_"
                                    << "1 0 0.2";
    QTest::addRow("shorts") << "ushort"
                            << ""
                            << "65535 0 13107";
}

void PlyTest::readsColoursOfAnyType() {
    QFETCH(QString, type);
    QFETCH(QString, prefix);
    QFETCH(QString, colour);
    QString file =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nproperty float quality\n";
    for (const char* channel : {"red", "green", "blue"}) {
        file += "property " + type + " " + prefix + channel + "\n";
    }
    file += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (const char* position : {"0 0 0", "1 0 0", "0 1 0"}) {
        file += QString(position) + " 0.5 " + colour + "\n";
    }
    const Result<ImportedMesh> read = parsePly((file + "3 0 1 2\n").toStdString());
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QCOMPARE(read.value().mesh.colours, std::vector<glm::vec3>(3, glm::vec3(1.0f, 0.0f, 0.2f)));
}

void PlyTest::readsFaceTexcoords() {
    const Result<ImportedMesh> result = parsePly(
        "ply\nformat ascii 1.0\ncomment TextureFile my wood.png\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\n"
        "property list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1\n3 2 1 0 "
        "0\n");
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    const MeshData& mesh = result.value().mesh;
    QCOMPARE(mesh.cornerTexcoords, (Indices{0, 1, 2, kNoIndex, kNoIndex, kNoIndex}));
    QCOMPARE(mesh.texcoords, (std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 1}}));
    QCOMPARE(mesh.materials.at(0).diffuseTexture, std::string("my wood.png"));
    QCOMPARE(mesh.faceMaterials, (Indices{0, 0}));
}

void PlyTest::leavesOutSmallFaces() {
    const Result<ImportedMesh> result = parsePly(asciiPly("3", "3", "0 0 0 1 0 0 0 1 0 2 0 1 3 0 1 2 0\n"));
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    QCOMPARE(result.value().mesh.faceStarts, (Indices{0, 3}));
    QVERIFY(result.value().notes.at(0).startsWith(QStringLiteral("2 faces with fewer than three corners")));
}

void PlyTest::notesWhatFollows() {
    const QStringList note{
        QStringLiteral("The file goes on after what its header names; the rest was not read.")};
    const auto notesOf = [](const std::string& file) {
        const Result<ImportedMesh> result = parsePly(file);
        return result ? result.value().notes : QStringList{messageOf(result)};
    };
    const std::string ascii = asciiPly("3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2");
    QCOMPARE(notesOf(ascii), QStringList());
    QCOMPARE(notesOf(ascii + "\r\n \n\n"), QStringList());
    QCOMPARE(notesOf(ascii + "\n3 0 1 2\n"), note);
    for (const bool big : {false, true}) {
        QCOMPARE(notesOf(binaryPly(big)), QStringList());
        QCOMPARE(notesOf(binaryPly(big) + std::string(3, '\0') + "\n"), QStringList());
        QCOMPARE(notesOf(binaryPly(big) + std::string("\0\0\1\0", 4)), note);
    }
}

void PlyTest::refuses_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& file, const char* message) {
        QTest::newRow(name) << QByteArray::fromStdString(file) << message;
    };
    row("not a ply", "GIF89a", "does not begin with \"ply\"");
    row("header cut", "ply\nformat ascii 1.0\nelement ver", "is not a line of a PLY header");
    row("stray line", "ply\nformat ascii 1.0\nelement vertex 1\nproprty float x\nend_header\n", "line 4");
    row("no end of header", "ply\nformat ascii 1.0\n", "ends inside its header");
    row("no format", "ply\nelement vertex 0\nend_header\n", "does not say which format");
    row("unknown format", "ply\nformat utf8 1.0\nend_header\n", "line 2: \"format utf8 1.0\" is not");
    row("unknown type", "ply\nformat ascii 1.0\nelement vertex 1\nproperty complex x\nend_header\n",
        "line 4");
    row("float list length", "ply\nformat ascii 1.0\nelement face 1\nproperty list float int a\nend_header\n",
        "line 4");
    row("negative count", asciiPly("-1", "1", ""), "line 3");
    row("count no whole number", asciiPly("3.9", "1", "0 0 0\n"), "line 3: \"element vertex 3.9\" is not");
    row("count with an exponent", asciiPly("3e0", "1", "0 0 0\n"), "line 3: \"element vertex 3e0\" is not");
    row("list length no whole number", asciiPly("1", "1", "0 0 0\n3.5 0 0 0\n"),
        "face 1: The length of a list is no whole number");
    row("huge vertex count", asciiPly("4000000000", "1", "0 0 0\n"), "promises 4000000000 of \"vertex\"");
    row("huger vertex count", asciiPly("18446744073709551615", "1", "0 0 0\n"), "of \"vertex\"");
    row("huge face count", asciiPly("1", "99999999", "0 0 0\n"), "promises 99999999 of \"face\"");
    row("huge list", asciiPly("1", "1", "0 0 0\n2000000000 1 2 3\n"), "face 1: The file ends in the middle");
    row("negative list", asciiPly("1", "1", "0 0 0\n-3 1 2 3\n"), "A list has a negative length");
    row("nan list", asciiPly("1", "1", "0 0 0\nnan 1 2 3\n"), "A list has a negative length");
    row("index too large", asciiPly("1", "1", "0 0 0\n3 0 0 7\n"),
        "face 1: It refers to vertex 7 (counted from 0)");
    row("index just too large", asciiPly("1", "1", "0 0 0\n3 0 0 1\n"), "face 1: It refers to vertex 1");
    row("index negative", asciiPly("1", "1", "0 0 0\n3 0 0 -7\n"), "It refers to a vertex that cannot be");
    row("index no whole number", asciiPly("1", "1", "0 0 0\n3 0 0 0.5\n"),
        "It refers to a vertex that cannot be");
    row("nan", asciiPly("1", "1", "0 nan 0\n3 0 0 0\n"), "vertex 1: A coordinate is not a number");
    row("word", asciiPly("1", "1", "0 0 zero\n3 0 0 0\n"), "vertex 1: \"zero\" is not a number");
    row("no z",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n1 2 3 4\n",
        "no x, y and z");
    row("faces without indices",
        "ply\nformat ascii 1.0\nelement face 1\nproperty int x\nend_header\n1 2 3 4\n", "no vertex_indices");
}

void PlyTest::refuses() {
    QFETCH(QByteArray, file);
    QFETCH(QString, message);
    const Result<ImportedMesh> result = parsePly({file.constData(), static_cast<std::size_t>(file.size())});
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
}

void PlyTest::refusesEveryTruncation() {
    for (const bool big : {false, true}) {
        const std::string whole = binaryPly(big);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const Result<ImportedMesh> result = parsePly(std::string_view(whole).substr(0, size));
            QVERIFY2(!result.ok(), qPrintable(QString::number(size)));
            QVERIFY(!result.error().advice.empty());
        }
    }
}

HITSCOPE_TEST(PlyTest, QCoreApplication)

}  // namespace hitscope::io_ply_test

#include "io_ply_test.moc"
