// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_write_ply_test {

using namespace test;

namespace {

const char* const kAscii =
    "ply\r\nformat ascii 1.0\r\ncomment of mine\r\nobj_info kept\r\nelement camera 1\r\nproperty list uchar "
    "short "
    "view\r\nelement vertex 4\r\nproperty uchar quality\r\nproperty float x\r\nproperty double y\r\nproperty "
    "float z\r\nproperty list uchar int more\r\nelement face 2\r\nproperty list uchar int "
    "vertex_indices\r\nproperty uchar flags\r\nelement edge 1\r\nproperty int vertex1\r\nend_header\r\n"
    "2  7 -8\r\n1  0.10 1e0 +0\r\t2 1 9 \r\n2 1 0.1 0 2 8 9\r\n3\t1 1 0 0\r\n4 0 1 0.50 1 4\r\n"
    "3 0 1 2 7\r\n4 0 1 2 3 9\r\n3\r\ntrailing";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? "not there: " + from : text.replace(at, from.size(), to);
}

/// A list before the vertices, x as double, y as a whole number, further properties, faces and edges.
template <bool IsBig>
std::string binarySource() {
    std::string text =
        std::string("ply\nformat ") + (IsBig ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\nelement first 2\nproperty list uchar short view\nelement vertex 3\nproperty double "
        "x\nproperty "
        "int y\nproperty float z\nproperty float confidence\nelement face 1\nproperty list uchar uint "
        "vertex_index\nproperty ushort flags\nend_header\n";
    const auto add = [&text](auto number) {
        std::string bytes;
        put(bytes, number);
        text += IsBig ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
    };
    add(std::uint8_t{2}), add(std::int16_t{-7}), add(std::int16_t{300}), add(std::uint8_t{0});
    for (int v = 0; v < 3; ++v) {
        add(0.1 * v), add(std::int32_t{v * v}), add(0.5f), add(0.25f + static_cast<float>(v));
    }
    add(std::uint8_t{3}), add(std::uint32_t{0}), add(std::uint32_t{1}), add(std::uint32_t{2});
    add(std::uint16_t{0xabcd});
    return text + "rest";
}

PlyOptions nothingAdded() {
    PlyOptions options;
    options.displacement = options.length = options.hits = false;
    return options;
}

class TestIoWritePly : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void comesBackByteForByte_data() {
        QTest::addColumn<QByteArray>("source");
        QTest::newRow("ascii") << QByteArray(kAscii);
        QTest::newRow("little") << QByteArray::fromStdString(binarySource<false>());
        QTest::newRow("big") << QByteArray::fromStdString(binarySource<true>());
    }
    void comesBackByteForByte() {
        QFETCH(QByteArray, source);
        QTemporaryDir folder;
        const DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), source.toStdString()));
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, nothingAdded());
        QVERIFY2(written, qPrintable(messageOf(written)));
        QCOMPARE(written.value(), QStringList());
        QCOMPARE(QByteArray::fromStdString(readFile(path)), source);
    }

    void replacesOnlyWhatMovedInText() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), kAscii));
        mesh.move(1, {0.5f, 0.0f, 0.25f});
        mesh.hits[1] = 12;
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        QVERIFY(exportPly(mesh.what(), path, {}));
        std::string expected = replaced(kAscii, "more\r\n",
                                        "more\r\nproperty float dx\r\nproperty float dy\r\nproperty float "
                                        "dz\r\nproperty float displacement\r\nproperty uint hits\r\n");
        expected = replaced(expected, "2 1 9 \r\n2 1 0.1 0 2 8 9\r\n",
                            "2 1 9 0 0 0 0 0 \r\n2 1.5 0.1 0.25 2 8 9 0.5 0 0.25 0.559017 12\r\n");
        expected = replaced(expected, "1 1 0 0\r\n4 0 1 0.50 1 4\r\n",
                            "1 1 0 0 0 0 0 0 0\r\n4 0 1 0.50 1 4 0 0 0 0 0\r\n");
        QCOMPARE(QByteArray::fromStdString(readFile(path)), QByteArray::fromStdString(expected));
    }

    void replacesOnlyWhatMovedInBytes() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), binarySource<true>()));
        mesh.move(2, {0.5f, 0.75f, -1.0f});
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, {});
        QVERIFY(written);
        QVERIFY2(written.value().join(u' ').contains(QStringLiteral("whole numbers")),
                 qPrintable(written.value().join(u' ')));
        const std::string bytes = readFile(path);
        QCOMPARE(bytes.size(), binarySource<true>().size() + 3 * 20 +
                                   std::string("property float dx\n").size() * 3 +
                                   std::string("property float displacement\nproperty uint hits\n").size());
        QVERIFY(bytes.ends_with("\xab\xcdrest"));
        const MeshData back = readBack(path);
        QCOMPARE(back.positions[2], glm::vec3(0.7f, 5.0f, -0.5f));
        QCOMPARE(back.filePositions[1], mesh.original.mesh.filePositions[1]);
        QCOMPARE(back.cornerVertices, mesh.original.mesh.cornerVertices);
    }

    void strayLinesBecomeComments() {
        QTemporaryDir folder;
        const std::string source = replaced(kAscii, "obj_info kept", "Made by a program");
        const DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), source));
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        QVERIFY(exportPly(mesh.what(), path, {}));
        QVERIFY(readFile(path).find("\r\ncomment Made by a program\r\nelement camera") != std::string::npos);
    }

    void longFilesAreReadInParts_data() {
        QTest::addColumn<int>("blanks");
        QTest::newRow("short") << 0;
        QTest::newRow("blanks up to where a part ends in a number") << (1 << 20) - 3;
    }
    void longFilesAreReadInParts() {
        QFETCH(int, blanks);
        constexpr int kVertices = 60000;  // more than one part
        std::string source =
            "ply\nformat ascii 1.0\nelement vertex " + std::to_string(kVertices) +
            "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
            "vertex_indices\nend_header\n";
        source += std::string(static_cast<std::size_t>(blanks), ' ');
        for (int v = 0; v < kVertices; ++v) {
            source += std::to_string(100000 + v) + " 0." + std::to_string(v % 10) + " 5.25\n";
        }
        source += "3 0 1 2\n";
        QTemporaryDir folder;
        const DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), source));
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, nothingAdded());
        QVERIFY(written);
        QCOMPARE(written.value(), QStringList());
        QVERIFY(readFile(path) == source);
    }

    void normalsThatTurnedAreReplaced() {
        QTemporaryDir folder;
        const std::string source =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
            "z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list uchar "
            "int "
            "vertex_indices\nend_header\n0 0 0 0 0 2.0\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n";
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), source));
        mesh.normals = {{0, 0, 1}, {0, 1, 0}, {0, 0, 1}};
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        QVERIFY(exportPly(mesh.what(), path, nothingAdded()));
        QCOMPARE(QByteArray::fromStdString(readFile(path)),
                 QByteArray::fromStdString(replaced(source, "1 0 0 0 0 1\n", "1 0 0 0 1 0\n")));
    }

    void keepsAllInAnotherEncoding() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), binarySource<true>()));
        PlyOptions options = nothingAdded();
        options.encoding = PlyOptions::Encoding::Ascii;
        const QString text = folder.filePath(QStringLiteral("text.ply"));
        QVERIFY(exportPly(mesh.what(), text, options));
        const std::string body = readFile(text);
        QVERIFY2(
            body.ends_with("end_header\n2 -7 300\n0\n0 0 0.5 0.25\n0.1 1 0.5 1.25\n0.2 4 0.5 2.25\n3 0 1 2 "
                           "43981\n"),
            body.c_str());
        DentedFile again(text);
        options.encoding = PlyOptions::Encoding::Binary;
        const QString binary = folder.filePath(QStringLiteral("binary.ply"));
        QVERIFY(exportPly(again.what(), binary, options));
        QCOMPARE(readFile(binary) + "rest", binarySource<false>());
    }

    void namesThatAreTakenGetANumber() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"),
                                  replaced(kAscii, "uchar quality", "uchar hits")));
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, {});
        QVERIFY(written);
        QVERIFY(written.value().join(u' ').contains(QStringLiteral("hits_2")));
        QVERIFY(readFile(path).find("property uint hits_2\r\n") != std::string::npos);
    }

    void anotherSourceIsNotCopied_data() {
        QTest::addColumn<QByteArray>("now");
        QTest::addColumn<QString>("why");
        const std::string source = kAscii;
        const auto row = [](const char* name, const std::string& now, const char* why) {
            QTest::newRow(name) << QByteArray::fromStdString(now) << QString::fromLatin1(why);
        };
        row("moved", replaced(source, "4 0 1 0.50", "4 0 1 0.51"), "vertex 4");
        row("face", replaced(source, "4 0 1 2 3 9", "4 0 1 3 2 9"), "faces");
        row("shorter face", replaced(source, "4 0 1 2 3 9", "3 0 1 2 9"), "faces");
        row("vertices", replaced(replaced(source, "vertex 4", "vertex 3"), "4 0 1 0.50 1 4\r\n", ""),
            "number");
        row("cut", source.substr(0, source.size() - 40), "whole");
        row("no ply", "solid\n", "PLY");
    }
    void anotherSourceIsNotCopied() {
        QFETCH(QByteArray, now);
        QFETCH(QString, why);
        QTemporaryDir folder;
        const QString source = writeFile(folder.path(), QStringLiteral("a.ply"), kAscii);
        DentedFile mesh(source);
        mesh.move(0, {0.0f, 0.0f, 1.0f});
        writeFile(folder.path(), QStringLiteral("a.ply"), now.toStdString());
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, {});
        QVERIFY2(written, qPrintable(messageOf(written)));
        QVERIFY2(written.value().value(0).contains(why), qPrintable(written.value().join(u' ')));
        const MeshData back = readBack(path);
        QCOMPARE(back.cornerVertices, mesh.original.mesh.cornerVertices);
        QVERIFY(std::ranges::equal(back.positions, mesh.positions));
    }

    void wholeMeshes_data() {
        QTest::addColumn<PlyOptions::Encoding>("encoding");
        QTest::newRow("binary") << PlyOptions::Encoding::AsSource;
        QTest::newRow("ascii") << PlyOptions::Encoding::Ascii;
    }
    void wholeMeshes() {
        QFETCH(PlyOptions::Encoding, encoding);
        QTemporaryDir folder;
        DentedFile mesh(
            writeFile(folder.path(), QStringLiteral("a.obj"),
                      "v 0.1 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 0 0 0.2\nv 7 7 7 1 1 1\nvt 0.1 "
                      "0.2\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3 4/1\nf 1/2 3/1 2/3\nf 1 2 3\n"));
        mesh.move(2, {0.0f, 0.0f, 0.3f});
        mesh.normals.assign(10, {0.0f, 0.0f, 1.0f});
        PlyOptions options;
        options.encoding = encoding;
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, options);
        QVERIFY2(written, qPrintable(messageOf(written)));
        const MeshData back = readBack(path);
        const MeshData& from = mesh.original.mesh;
        QCOMPARE(back.positions[2], mesh.positions[2]);
        QCOMPARE(back.filePositions, [&] {
            std::vector<glm::dvec3> now = from.filePositions;
            now[2] = glm::dvec3(mesh.positions[2]);
            return now;
        }());
        QCOMPARE(back.cornerVertices, from.cornerVertices);
        QCOMPARE(back.faceStarts, from.faceStarts);
        QCOMPARE(back.colours, from.colours);
        QCOMPARE(back.normals.size(), std::size_t{5});
        for (std::size_t c = 0; c < 10; ++c) {
            const std::uint32_t then = from.cornerTexcoords[c];
            const std::uint32_t now = back.cornerTexcoords[c];
            QCOMPARE(now == kNoIndex, then == kNoIndex);
            QVERIFY(now == kNoIndex || back.texcoords[now] == from.texcoords[then]);
        }
    }

    void textureCoordinatesStay_data() {
        QTest::addColumn<QByteArray>("faces");
        QTest::addColumn<bool>("ofVertices");
        QTest::newRow("one for each vertex") << QByteArray("f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n") << true;
        QTest::newRow("a seam") << QByteArray("f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n") << false;
    }
    void textureCoordinatesStay() {
        QFETCH(QByteArray, faces);
        QFETCH(bool, ofVertices);
        QTemporaryDir folder;
        const std::string vertices =
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.2\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.7 0.7\n";
        const DentedFile mesh(
            writeFile(folder.path(), QStringLiteral("a.obj"), vertices + faces.toStdString()));
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        QVERIFY(exportPly(mesh.what(), path, {}));
        QCOMPARE(readFile(path).find("property float s\n") != std::string::npos, ofVertices);
        const MeshData& from = mesh.original.mesh;
        const MeshData back = readBack(path);
        QCOMPARE(back.cornerTexcoords.size(), std::size_t{6});
        for (std::size_t c = 0; c < 6; ++c) {
            QCOMPARE(back.texcoords[back.cornerTexcoords[c]], from.texcoords[from.cornerTexcoords[c]]);
        }
    }

    void linesBecomeEdges_data() { wholeMeshes_data(); }
    void linesBecomeEdges() {
        QFETCH(PlyOptions::Encoding, encoding);
        QTemporaryDir folder;
        const DentedFile mesh(
            writeFile(folder.path(), QStringLiteral("a.obj"),
                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 5 5\nf 1 2 3\nl 1 2 4\nl 3 1\np 2\n"));
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, {.encoding = encoding});
        QVERIFY2(written, qPrintable(messageOf(written)));
        QCOMPARE(written.value(),
                 QStringList{QStringLiteral("PLY has no point elements; they are left out.")});
        QVERIFY(readFile(path).find("element edge 3\nproperty int vertex1\nproperty int vertex2\n") !=
                std::string::npos);
        const std::vector<std::vector<std::uint32_t>> edges{{0, 1}, {1, 3}, {2, 0}};
        QCOMPARE(readBack(path).lines, edges);
        const DentedFile again(path);  // and a copy of them
        const QString copy = folder.filePath(QStringLiteral("c.ply"));
        QVERIFY(exportPly(again.what(), copy, nothingAdded()));
        QVERIFY(readFile(copy) == readFile(path));
    }

    void otherEdgesAreNotCopied() {
        const std::string source =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
            "property uchar red\nproperty int vertex2\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 9 1\n";
        QTemporaryDir folder;
        const DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), source));
        QCOMPARE(mesh.original.mesh.lines, (std::vector<std::vector<std::uint32_t>>{{2, 1}}));
        writeFile(folder.path(), QStringLiteral("a.ply"), replaced(source, "2 9 1", "2 9 0"));
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, {});
        QVERIFY2(written, qPrintable(messageOf(written)));
        QVERIFY(written.value().value(0).contains(QStringLiteral("edges")));
        QCOMPARE(readBack(path).lines, mesh.original.mesh.lines);
        const QString bad =
            writeFile(folder.path(), QStringLiteral("c.ply"), replaced(source, "2 9 1", "2 9 3"));
        QVERIFY(messageOf(readMesh(bad, {})).contains(QStringLiteral("edge 1")));
    }

    void hardEdgesLoseTheirNormals() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"),
                                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 3 2\n"));
        mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, 1}, {0, 0, 1}};
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        const Result<QStringList> written = exportPly(mesh.what(), path, {});
        QVERIFY(written);
        QVERIFY(written.value().join(u' ').contains(QStringLiteral("normal")));
        QVERIFY(readBack(path).normals.empty());
    }

    void placedMeshesGoBackToTheirFile() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), kAscii));
        place(mesh.original.mesh, 0.5f);
        mesh.positions.assign(mesh.original.mesh.positions.begin(), mesh.original.mesh.positions.end());
        const QString path = folder.filePath(QStringLiteral("b.ply"));
        QVERIFY(exportPly(mesh.what(), path, nothingAdded()));
        QCOMPARE(readFile(path), std::string(kAscii));
        mesh.move(1, {0.25f, 0.0f, 0.0f});
        QVERIFY(exportPly(mesh.what(), path, {}));
        QVERIFY(qAbs(readBack(path).positions[1].x - 1.5f) < 1e-5f);
        QVERIFY2(readFile(path).find(" 0.5 0 0 0.5 1\r\n") != std::string::npos, readFile(path).c_str());
    }

    void givenUpNothingIsWritten() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.ply"), kAscii));
        const QString path = writeFile(folder.path(), QStringLiteral("b.ply"), "before");
        for (int looks = 0; looks < 6; ++looks) {
            MeshExport what = mesh.what();
            int left = looks;
            what.goOn = [&left](ExportStep, double fraction) {
                return fraction >= 0.0 && fraction <= 1.0 && left-- > 0;
            };
            const Result<QStringList> written = exportPly(what, path, {});
            QVERIFY(!written);
            QVERIFY(messageOf(written).contains(QStringLiteral("cancelled")));
            QCOMPARE(readFile(path), std::string("before"));
        }
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
    }

    void ontoItsOwnSource() {
        QTemporaryDir folder;
        const QString path = writeFile(folder.path(), QStringLiteral("a.ply"), kAscii);
        DentedFile mesh(path);
        mesh.move(3, {0.0f, 0.0f, 1.0f});
        QVERIFY(exportPly(mesh.what(), path, nothingAdded()));
        QCOMPARE(readFile(path), replaced(kAscii, "4 0 1 0.50 1 4", "4 0 1 1.5 1 4"));
    }
};

}  // namespace

HITSCOPE_TEST(TestIoWritePly, QCoreApplication)

}  // namespace hitscope::io_write_ply_test

#include "io_write_ply_test.moc"
