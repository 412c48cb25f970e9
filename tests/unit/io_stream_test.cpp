// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <limits>
#include <random>

#include "io/mesh_stream.h"
#include "io/worker_protocol.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_stream_test {

using namespace test;

namespace {

MeshData everything() {
    MeshData mesh;
    mesh.name = "all of it";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 5, 5}};
    mesh.filePositions = {{10, 10, 10}, {10.1, 10, 10}, {10, 10.1, 10}, {10, 10.5, 10.5}};
    mesh.sourceHash = 7;
    mesh.placement = {{10, 10, 10}, 10.0};
    mesh.colours.assign(4, glm::vec3(0.5f));
    mesh.normals = {{0, 0, 1}};
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    mesh.faceStarts = {0, 3, 7};
    mesh.cornerVertices = {0, 1, 2, 0, 1, 2, 3};
    mesh.cornerTexcoords = {0, 1, 2, kNoIndex, kNoIndex, kNoIndex, 0};
    mesh.cornerNormals = {0, 0, 0, 0, 0, kNoIndex, 0};
    mesh.faceMaterials = {0, kNoIndex};
    mesh.faceSmoothing = {1, 0};
    mesh.groups = {{FaceGroup::Kind::Object, "o", 0}, {FaceGroup::Kind::Group, "g", 1}};
    mesh.materials.resize(1);
    mesh.materials[0].name = std::string("metal");
    mesh.materials[0].shininess = 7.0f;
    mesh.materials[0].diffuseTexture = "t.png";
    mesh.materials[0].diffuseImage = 0;
    mesh.materials[0].metalRoughness = {0.5f, 0.25f, "rough.png", 0};
    mesh.images = {Image{1, 2, {1, 2, 3, 4, 5, 6, 7, 8}}};
    mesh.lines = {{0, 1}, {}};
    mesh.points = {3};
    mesh.materialLibraries = {"m.mtl"};
    mesh.pictureFiles = {"a.png", "b.png"};
    return mesh;
}

}  // namespace

class StreamTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void carriesEverything();
    void refusesTruncations();
    void survivesMutations();
    void refusesWhatCannotBeDrawn_data();
    void refusesWhatCannotBeDrawn();
    void takesNoMoreMemoryThanItMay();
    void refusesAPipe();
    void canBeCancelled();
    void saysWhenItCannotWrite();
    void protocolLines();
    void protocolGarbage();

private:
    [[nodiscard]] QString path() const { return m_folder.filePath(QStringLiteral("mesh")); }
    QTemporaryDir m_folder;
};

void StreamTest::carriesEverything() {
    const MeshData mesh = everything();
    QVERIFY(validate(mesh).ok());
    QVERIFY(writeMeshStream(mesh, path()).ok());
    const Result<MeshData> again = readMeshStream(path());
    QVERIFY2(again.ok(), qPrintable(messageOf(again)));
    QCOMPARE(differences(again.value(), mesh), QStringList());
    QCOMPARE(again.value().name, mesh.name);
    QCOMPARE(again.value().sourceHash, mesh.sourceHash);
    QCOMPARE(again.value().materialLibraries, mesh.materialLibraries);
    QCOMPARE(again.value().pictureFiles, mesh.pictureFiles);
}

void StreamTest::refusesTruncations() {
    QVERIFY(writeMeshStream(everything(), path()).ok());
    const std::string whole = readFile(path());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const QString cut = writeFile(m_folder.path(), QStringLiteral("cut"), whole.substr(0, size));
        QVERIFY2(!readMeshStream(cut), qPrintable(QString::number(size)));
    }
    std::string longer = whole;
    longer.push_back('x');
    QVERIFY(!readMeshStream(writeFile(m_folder.path(), QStringLiteral("long"), longer)));
    QVERIFY(!readMeshStream(m_folder.filePath(QStringLiteral("missing"))));
}

void StreamTest::survivesMutations() {
    QVERIFY(writeMeshStream(everything(), path()).ok());
    const std::string whole = readFile(path());
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
        std::string bytes = whole;
        for (int change = 0; change < 3; ++change) {
            bytes[random() % bytes.size()] = static_cast<char>(random() % 3 == 0 ? 0xff : random());
        }
        const Result<MeshData> result =
            readMeshStream(writeFile(m_folder.path(), QStringLiteral("mutated"), bytes));
        QVERIFY(result ? validate(result.value()).ok() : !result.error().what.empty());
    }
}

void StreamTest::refusesWhatCannotBeDrawn_data() {
    using Spoil = std::function<void(MeshData&)>;
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    QTest::addColumn<Spoil>("spoil");
    const auto row = [](const char* title, const Spoil& spoil) { QTest::newRow(title) << spoil; };
    row("position", [](MeshData& mesh) { mesh.positions[1].y = kNan; });
    row("normal", [](MeshData& mesh) { mesh.normals[0].z = kNan; });
    row("texture coordinate",
        [](MeshData& mesh) { mesh.texcoords[2].x = std::numeric_limits<float>::infinity(); });
    row("index", [](MeshData& mesh) { mesh.cornerVertices[3] = 4; });
    row("colour", [](MeshData& mesh) { mesh.materials[0].diffuse.y = 1.5f; });
    row("no colour", [](MeshData& mesh) { mesh.materials[0].specular.z = kNan; });
    row("shininess", [](MeshData& mesh) { mesh.materials[0].shininess = 0.0f; });
    row("opacity", [](MeshData& mesh) { mesh.materials[0].opacity = kNan; });
    row("flat picture", [](MeshData& mesh) { mesh.images[0] = Image{0, 7, {}}; });
    row("long picture", [](MeshData& mesh) {
        mesh.images[0] = Image{8193, 1, std::vector<std::uint8_t>(4 * 8193)};
    });
}

void StreamTest::refusesWhatCannotBeDrawn() {
    QFETCH(std::function<void(MeshData&)>, spoil);
    MeshData mesh = everything();
    spoil(mesh);
    QVERIFY(writeMeshStream(mesh, path()).ok());
    QVERIFY(!readMeshStream(path()));
}

/// Four bytes of memory for each of the stream, where there are names without letters.
void StreamTest::takesNoMoreMemoryThanItMay() {
    MeshData mesh = everything();
    mesh.materialLibraries.resize(10000);
    QVERIFY(writeMeshStream(mesh, path()).ok());
    QVERIFY(readMeshStream(path()).ok());
    QVERIFY(readMeshStream(path(), {}, nullptr, 1 << 20).ok());
    const QString message = messageOf(readMeshStream(path(), {}, nullptr, 100 << 10));
    QVERIFY2(message.contains(QStringLiteral("it takes more memory than it may have")), qPrintable(message));
}

void StreamTest::refusesAPipe() {
    const QString pipe = m_folder.filePath(QStringLiteral("pipe"));
    QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    QVERIFY(messageOf(readMeshStream(pipe)).contains(QStringLiteral("it is no file")));
}

void StreamTest::canBeCancelled() {
    QVERIFY(writeMeshStream(everything(), path()).ok());
    const std::atomic_bool cancelled = true;
    QVERIFY(!readMeshStream(path(), {}, &cancelled));
}

void StreamTest::saysWhenItCannotWrite() {
    const Status full = writeMeshStream(everything(), QStringLiteral("/dev/full"));
    QVERIFY2(messageOf(full).contains(QStringLiteral("No space left")), qPrintable(messageOf(full)));
    QVERIFY(!writeMeshStream(everything(), m_folder.filePath(QStringLiteral("nowhere/mesh"))));
}

void StreamTest::protocolLines() {
    const auto there = [](const WorkerMessage& message) {
        const QByteArray line = formatWorkerLine(message);
        return line.endsWith('\n') && line.count('\n') == 1 ? parseWorkerLine(line.chopped(1))
                                                            : WorkerMessage();
    };
    const WorkerMessage progress = there(WorkerProgress{0.25, QStringLiteral("Reading OBJ")});
    QCOMPARE(std::get<WorkerProgress>(progress).fraction, 0.25);
    QCOMPARE(std::get<WorkerProgress>(progress).doing, QStringLiteral("Reading OBJ"));
    QCOMPARE(std::get<WorkerNote>(there(WorkerNote{QStringLiteral("two\nlines")})).text,
             QStringLiteral("two lines"));
    const Error error = std::get<Error>(there(Error{"what \"it\"\n is", "a\tb", ""}));
    QCOMPARE(error.what, std::string("what \"it\"\n is"));
    QCOMPARE(error.where, std::string("a\tb"));
    QVERIFY(error.advice.empty());
}

void StreamTest::protocolGarbage() {
    for (const char* const line : {"", "progress", "progress x", "progress nan", "error", "error {}",
                                   "error [1]", "error [\"\"]", "note", "hello", "\xff\xfe"}) {
        QVERIFY2(std::holds_alternative<std::monostate>(parseWorkerLine(line)), line);
    }
    QCOMPARE(std::get<WorkerProgress>(parseWorkerLine("progress 7 x")).fraction, 1.0);
}

HITSCOPE_TEST(StreamTest, QCoreApplication)

}  // namespace hitscope::io_stream_test

#include "io_stream_test.moc"
