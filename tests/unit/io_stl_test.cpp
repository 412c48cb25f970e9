// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <limits>

#include "io/readers/stl_reader.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_stl_test {

using namespace test;
using Indices = std::vector<std::uint32_t>;

namespace {

/// Two triangles with a common edge, one of whose vertices is written as -0 once.
std::string binaryStl(const std::string& header = "made by a test") {
    std::string file = header;
    file.resize(80, ' ');
    put(file, std::uint32_t{2});
    put(file, 9.0f, 9.0f, 9.0f, /**/ 0.0f, 0.0f, 0.0f, /**/ 1.0f, 0.0f, 0.0f, /**/ 0.0f, 1.0f, 0.0f,
        std::uint16_t{3});
    put(file, 9.0f, 9.0f, 9.0f, /**/ 0.0f, 1.0f, -0.0f, /**/ 1.0f, 0.0f, 0.0f, /**/ 1.0f, 1.0f, 0.0f,
        std::uint16_t{3});
    return file;
}

const char* const kAscii =
    "solid left part\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n "
    "endloop\n"
    "endfacet\nfacet normal 0 0 1\n outer loop\n  vertex 0 1 -0\n  vertex 1 0 0\n  vertex 1 1 0\n "
    "endloop\nendfacet\n"
    "endsolid\n";

}  // namespace

class StlTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void weldsEqualPositions_data();
    void weldsEqualPositions();
    void weldsManyPositions();
    void namesSolids();
    void refuses_data();
    void refuses();
    void refusesEveryTruncation();
};

void StlTest::weldsEqualPositions_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::newRow("binary") << QByteArray::fromStdString(binaryStl());
    QTest::newRow("binary that says solid") << QByteArray::fromStdString(binaryStl("solid made by a test"));
    QTest::newRow("binary that says SOLID, with more behind")
        << QByteArray::fromStdString(binaryStl("SOLID made by a test") + "more");
    QTest::newRow("ascii") << QByteArray(kAscii);
    QTest::newRow("capitals") << QByteArray(kAscii).toUpper();
    QTest::newRow("some capitals")
        << QByteArray(kAscii).replace("vertex", "VERTEX").replace("solid", "Solid");
    QTest::newRow("byte order mark") << "\xEF\xBB\xBF" + QByteArray(kAscii);
}

void StlTest::weldsEqualPositions() {
    QFETCH(QByteArray, file);
    const Result<ImportedMesh> result = parseStl(file.toStdString());
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    const MeshData& mesh = result.value().mesh;
    QCOMPARE(mesh.positions, (PageVector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    QCOMPARE(mesh.cornerVertices, (Indices{0, 1, 2, 2, 1, 3}));
    QCOMPARE(mesh.faceStarts, (Indices{0, 3, 6}));
}

void StlTest::weldsManyPositions() {
    constexpr std::uint32_t kSide = 100;  // quads; enough for the table of positions to grow several times
    std::string file(80, ' ');
    put(file, std::uint32_t{2 * kSide * kSide});
    const auto corner = [&](std::uint32_t x, std::uint32_t y) {
        put(file, static_cast<float>(x), static_cast<float>(y), 0.0f);
    };
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        const std::uint32_t x = i % kSide;
        const std::uint32_t y = i / kSide;
        for (const std::uint32_t upper : {0u, 1u}) {
            corner(0, 0);
            corner(x, y + upper);
            corner(x + 1, y);
            corner(x + upper, y + 1);
            put(file, std::uint16_t{0});
        }
    }
    const Result<ImportedMesh> result = parseStl(file);
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    QCOMPARE(result.value().mesh.vertexCount(), std::size_t{(kSide + 1) * (kSide + 1)});
    QCOMPARE(result.value().mesh.faceCount(), std::size_t{2 * kSide * kSide});
}

void StlTest::namesSolids() {
    const Result<ImportedMesh> result = parseStl(std::string(kAscii) + "solid right\nendsolid right\n");
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    QCOMPARE(result.value().mesh.groups.size(), std::size_t(2));
    QCOMPARE(result.value().mesh.groups[0].name, std::string("left part"));
    QCOMPARE(result.value().mesh.groups[1].firstFace, 2u);
}

void StlTest::refuses_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("message");
    std::string huge(80, ' ');
    put(huge, std::uint32_t{4000000000u});
    QTest::newRow("huge count") << QByteArray::fromStdString(huge)
                                << "promises 4000000000 triangles, but ends after 0";
    QTest::newRow("short") << QByteArray("STL") << "too short";
    std::string nan = binaryStl();
    const float bad = std::numeric_limits<float>::quiet_NaN();
    nan.replace(84 + 50 + 12, 4, reinterpret_cast<const char*>(&bad), 4);
    QTest::newRow("nan") << QByteArray::fromStdString(nan) << "triangle 2: A coordinate is not a number";
    QTest::newRow("ascii nan") << QByteArray(kAscii).replace("1 1 0", "1 nan 0") << "line 13: A coordinate";
    QTest::newRow("ascii word") << QByteArray(kAscii).replace("1 1 0", "1 one 0")
                                << "line 13: A vertex needs three";
}

void StlTest::refuses() {
    QFETCH(QByteArray, file);
    QFETCH(QString, message);
    const Result<ImportedMesh> result = parseStl(file.toStdString());
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
}

void StlTest::refusesEveryTruncation() {
    const std::string whole = binaryStl();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        QVERIFY2(!parseStl(std::string_view(whole).substr(0, size)).ok(), qPrintable(QString::number(size)));
    }
    const std::string text(kAscii);
    for (std::size_t size = text.find("vertex 0"); size < text.find("endloop"); ++size) {
        QVERIFY2(!parseStl(std::string_view(text).substr(0, size)).ok(), qPrintable(QString::number(size)));
    }
}

HITSCOPE_TEST(StlTest, QCoreApplication)

}  // namespace hitscope::io_stl_test

#include "io_stl_test.moc"
