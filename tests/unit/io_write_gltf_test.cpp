// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <cstring>

#include "glb_support.h"
#include "io/check/written_check.h"
#include "io/import.h"
#include "mesh/corner_normals.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_write_gltf_test {

using namespace test;

namespace {

/// Two objects, two materials and none, a polygon, a seam in texture coordinates, a vertex that no face uses.
const char* const kScene =
    "mtllib s.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\nv 9 9 9 0 0 0\nv 0 0 1 0 0 "
    "0\nv 1 0 1 0 "
    "0.5 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\no plate\nusemtl wood\nf 1/1 2/2 3/3 4/4\nusemtl "
    "tin\nf 1/5 "
    "6/1 7/2\no flap\nf 1 7 2\n";
const char* const kMaterials =
    "newmtl wood\nKd 0.5 0.25 1\nKs 0.3 0.3 0.3\nNs 32\nmap_Kd wood grain.png\nnewmtl tin\nKd 1 0 0\nKs 0 0 "
    "0\nd 0.5\n";

/// As no writer of ours makes it.
QByteArray woodPng() {
    return smallPng() + "behind it";
}

struct Scene {
    QTemporaryDir folder;
    DentedFile mesh;

    Scene() : mesh(write()) { mesh.normals = cornerNormals(mesh.original.mesh, 0.7853982f); }
    QString write() {
        writeFile(folder.path(), QStringLiteral("s.mtl"), kMaterials);
        writeFile(folder.path(), QStringLiteral("wood grain.png"), woodPng().toStdString());
        QDir(folder.path()).mkdir(QStringLiteral("out"));
        return writeFile(folder.path(), QStringLiteral("s.obj"), kScene);
    }
    void dent() {
        mesh.move(2, {0.0f, 0.0f, -0.25f});
        mesh.move(6, {0.125f, 0.0f, 0.0f});
        for (std::size_t c = 0; c < mesh.normals.size(); ++c) {
            if (mesh.original.mesh.cornerVertices[c] == 2) {
                mesh.normals[c] = {0.6f, 0.0f, 0.8f};
            }
        }
    }
    [[nodiscard]] QString path(const char* name) const {
        return folder.filePath(QStringLiteral("out/") + QLatin1String(name));
    }
};

/// A strip of quads each of which has texture coordinates of its own.
std::string seamedStrip() {
    std::string text;
    for (int i = 0; i < 12; ++i) {
        text += "v " + std::to_string(i / 2) + " " + std::to_string(i % 2) + " 0\nvt 0." + std::to_string(i) +
                " 0.5\n";
    }
    for (int q = 1; q <= 5; ++q) {
        const auto corner = [q](int vertex) {
            return " " + std::to_string(vertex) + "/" + std::to_string(q);
        };
        text += "f" + corner(2 * q - 1) + corner(2 * q + 1) + corner(2 * q + 2) + corner(2 * q) + "\n";
    }
    return text;
}

class TestIoWriteGltf : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void holdsWhatWasMeant_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("steps");
        QTest::newRow("glb") << QStringLiteral("a.glb") << false;
        QTest::newRow("gltf") << QStringLiteral("a b.gltf") << false;
        QTest::newRow("steps") << QStringLiteral("a.glb") << true;
    }
    void holdsWhatWasMeant() {
        QFETCH(QString, name);
        QFETCH(bool, steps);
        Scene scene;
        scene.dent();
        MeshExport what = scene.mesh.what();
        what.steps = {{"Hit 1", {{2, {1.0f, 1.0f, -0.1f}}}},
                      {"Hit 2", {{2, scene.mesh.positions[2]}, {3, {0.0f, 1.5f, 0.0f}}}},
                      {"Hit 3", {{3, scene.mesh.positions[3]}}}};  // one that comes back, and one that lacks
        const QString path = scene.path(qPrintable(name));
        const Result<QStringList> written = exportGltf(what, path, {.steps = steps});
        QVERIFY2(written, qPrintable(messageOf(written)));
        const Status same = verifyWritten(path, what);
        QVERIFY2(same, qPrintable(messageOf(same)));
        if (path.endsWith(QStringLiteral("glb"))) {
            QCOMPARE(brokenRule(Glb(path)), QString());
        }
    }

    void otherProgramsReadIt() {  // Assimp
        Scene scene;
        scene.dent();
        const QString path = scene.path("a.glb");
        QVERIFY(exportGltf(scene.mesh.what(), path, {}));
        const MeshData back = readBack(path);
        QCOMPARE(back.faceCount(), std::size_t{4});
        QCOMPARE(back.groups.size(), std::size_t{2});  // of one, whose faces have two materials, and another
        QCOMPARE(back.groups[0].name, std::string("plate"));
        QCOMPARE(back.groups[1].name, std::string("flap"));
        QCOMPARE(back.materials.size(), std::size_t{2});
        QCOMPARE(back.materials[0].name, std::string("wood"));
        QCOMPARE(back.materials[0].diffuse, glm::vec3(0.5f, 0.25f, 1.0f));
        QCOMPARE(back.materials[1].opacity, 0.5f);
        QCOMPARE(back.images.size(), std::size_t{1});
        QCOMPARE(back.images[0].width, 2);
        const MeshData& from = scene.mesh.original.mesh;
        // The plate has a vertex that no face uses, its last one. Assimp leaves such vertices out since 5.4.
        const bool isWhole = back.positions.size() == 5 + 3 + 3;
        QVERIFY(isWhole || back.positions.size() == 4 + 3 + 3);
        for (std::size_t i = 0; i < (isWhole ? 5 : 4); ++i) {
            QCOMPARE(back.positions[i], scene.mesh.positions[i]);
            QVERIFY(i == 4 || glm::distance(back.texcoords[i], from.texcoords[i]) < 1e-6f);
            QVERIFY(i == 4 || glm::length(back.normals[i]) > 0.999f);
            // Light in the file, and sRGB again.
            QVERIFY(glm::distance(back.colours[i], from.colours[i]) < 1e-5f);
        }
    }

    void isReadBackAsFarAsItsWeightSays() {
        Scene scene;
        scene.dent();
        const QString path = scene.path("a.gltf");
        QVERIFY(exportGltf(scene.mesh.what(), path, {}));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        const QRegularExpression weights(QStringLiteral(R"("weights":\s*\[\s*1\s*\])"));
        QVERIFY(text.contains(weights));
        const glm::vec3 from = scene.mesh.original.mesh.positions[2];
        for (const float weight : {1.0f, 0.5f, 0.0f}) {
            QString weighed = text;
            weighed.replace(weights, QStringLiteral(R"("weights":[%1])").arg(weight));
            writeFile(scene.folder.path(), QStringLiteral("out/a.gltf"), weighed.toStdString());
            const Result<ImportedMesh> back = importMesh(path);
            QVERIFY2(back.ok(), qPrintable(messageOf(back)));
            QCOMPARE(back.value().mesh.positions[2], from + weight * (scene.mesh.positions[2] - from));
            const QString notes = back.value().notes.join(QLatin1Char(' '));
            QCOMPARE(notes.contains(QStringLiteral("Morph targets were applied")), weight > 0.0f);
            QCOMPARE(notes.contains(QStringLiteral("were left out")), weight == 0.0f);
        }
    }

    void theDeformedShapeIsShown() {
        Scene scene;
        scene.dent();
        const QString path = scene.path("a.glb");
        QVERIFY(exportGltf(scene.mesh.what(), path, {}));
        const Glb glb(path);
        const QJsonObject plate = glb.item("meshes", 0);
        QCOMPARE(plate[QStringLiteral("weights")].toArray(), QJsonArray{1.0});
        QCOMPARE(plate[QStringLiteral("extras")].toObject()[QStringLiteral("targetNames")].toArray(),
                 QJsonArray{QStringLiteral("Deformed")});
        const QJsonArray primitives = plate[QStringLiteral("primitives")].toArray();
        const QJsonObject target =
            primitives[0].toObject()[QStringLiteral("targets")].toArray()[0].toObject();
        const QJsonObject position = glb.item("accessors", target[QStringLiteral("POSITION")].toInt());
        QCOMPARE(position[QStringLiteral("sparse")].toObject()[QStringLiteral("count")].toInt(), 1);
        QCOMPARE(position[QStringLiteral("min")].toArray(), (QJsonArray{0.0, 0.0, -0.25}));
        QCOMPARE(position[QStringLiteral("max")].toArray(), (QJsonArray{0.0, 0.0, 0.0}));
        QCOMPARE(position[QStringLiteral("count")].toInt(), 5);
        const QJsonObject normal = glb.item("accessors", target[QStringLiteral("NORMAL")].toInt());
        const QJsonObject values =
            normal[QStringLiteral("sparse")].toObject()[QStringLiteral("values")].toObject();
        const QJsonObject view = glb.item("bufferViews", values[QStringLiteral("bufferView")].toInt());
        glm::vec3 turned;
        std::memcpy(static_cast<void*>(&turned),
                    glb.buffer.data() + view[QStringLiteral("byteOffset")].toInt(), sizeof turned);
        QVERIFY(glm::distance(turned, glm::vec3(0.6f, 0.0f, -0.2f)) < 1e-6f);
        QVERIFY(!view.contains(QStringLiteral("target")));
        QVERIFY(!glb.json.contains(QStringLiteral("animations")));
    }

    void stepsComeOneAfterTheOther() {
        Scene scene;
        scene.dent();
        MeshExport what = scene.mesh.what();
        what.steps = {{"Hit 1", {{2, {1.0f, 1.0f, -0.1f}}}},
                      {"Hits 2-3", {{2, scene.mesh.positions[2]}, {6, scene.mesh.positions[6]}}}};
        const QString path = scene.path("a.glb");
        QVERIFY(exportGltf(what, path, {.steps = true, .stepSeconds = 2.0}));
        const Glb glb(path);
        const QJsonObject plate = glb.item("meshes", 0);
        QCOMPARE(plate[QStringLiteral("weights")].toArray(), (QJsonArray{1.0, 0.0, 0.0}));
        QCOMPARE(
            plate[QStringLiteral("extras")].toObject()[QStringLiteral("targetNames")].toArray(),
            (QJsonArray{QStringLiteral("Deformed"), QStringLiteral("Hit 1"), QStringLiteral("Hits 2-3")}));
        const QJsonObject animation = glb.item("animations", 0);
        const QJsonObject sampler = animation[QStringLiteral("samplers")].toArray()[0].toObject();
        QCOMPARE(floatsOf(glb, sampler[QStringLiteral("input")].toInt()),
                 (std::vector<float>{0.0f, 2.0f, 4.0f}));
        QCOMPARE(floatsOf(glb, sampler[QStringLiteral("output")].toInt()),
                 (std::vector<float>{0, 0, 0, 0, 1, 0, 0, 1, 1}));
        // The flap is moved by the second step alone.
        QCOMPARE(animation[QStringLiteral("channels")].toArray().size(), 2);
        QCOMPARE(glb.item("meshes", 1)[QStringLiteral("weights")].toArray(), (QJsonArray{1.0, 0.0}));
        const QJsonObject second = animation[QStringLiteral("samplers")].toArray()[1].toObject();
        QCOMPARE(floatsOf(glb, second[QStringLiteral("output")].toInt()),
                 (std::vector<float>{0, 0, 0, 0, 0, 1}));
    }

    void verticesOnSeamsMoveTogether_data() {
        QTest::addColumn<int>("moved");
        QTest::newRow("sparse") << 3;
        QTest::newRow("dense") << 11;
    }
    void verticesOnSeamsMoveTogether() {
        QFETCH(int, moved);
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), seamedStrip()));
        for (int v = 0; v < moved; ++v) {
            mesh.move(static_cast<std::size_t>(v + 1), {0.0f, 0.0f, 0.5f});
        }
        const QString path = folder.filePath(QStringLiteral("a.glb"));
        QVERIFY(exportGltf(mesh.what(), path, {}));
        QVERIFY(verifyWritten(path, mesh.what()));
        const Glb glb(path);
        const QJsonObject primitive =
            glb.item("meshes", 0)[QStringLiteral("primitives")].toArray()[0].toObject();
        const QJsonObject attributes = primitive[QStringLiteral("attributes")].toObject();
        const std::vector<float> vertices = floatsOf(glb, attributes[QStringLiteral("_FILE_VERTEX")].toInt());
        QCOMPARE(vertices.size(), std::size_t{20});
        const int target =
            primitive[QStringLiteral("targets")].toArray()[0].toObject()[QStringLiteral("POSITION")].toInt();
        QCOMPARE(glb.item("accessors", target).contains(QStringLiteral("sparse")), moved == 3);
        const std::vector<float> deltas = floatsOf(glb, target);
        QCOMPARE(deltas.size(), std::size_t{60});
        for (std::size_t i = 0; i < 20; ++i) {
            const bool isMoved = vertices[i] >= 1.0f && vertices[i] <= static_cast<float>(moved);
            QCOMPARE(deltas[3 * i + 2], isMoved ? 0.5f : 0.0f);
        }
    }

    void refinedMeshesTellTheirOwnVertices() {
        QTemporaryDir folder;
        DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), seamedStrip()));
        std::vector<std::uint32_t>& sources = mesh.original.mesh.sourceVertices;
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
            sources.push_back(v % 3 == 1 ? kNoIndex : v / 3);
        }
        const QString path = folder.filePath(QStringLiteral("a.glb"));
        QVERIFY(exportGltf(mesh.what(), path, {}));
        const Glb glb(path);
        const QJsonObject attributes = glb.item("meshes", 0)[QStringLiteral("primitives")]
                                           .toArray()[0]
                                           .toObject()[QStringLiteral("attributes")]
                                           .toObject();
        const std::vector<float> vertices = floatsOf(glb, attributes[QStringLiteral("_FILE_VERTEX")].toInt());
        const std::vector<float> own = floatsOf(glb, attributes[QStringLiteral("_SOURCE_VERTEX")].toInt());
        QCOMPARE(own.size(), vertices.size());
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::uint32_t source = sources[static_cast<std::size_t>(vertices[i])];
            QCOMPARE(own[i], source == kNoIndex ? -1.0f : static_cast<float>(source));
        }
    }

    void normalsOfTheStepsAddUp() {
        Scene scene;
        scene.dent();
        MeshExport what = scene.mesh.what();
        scene.mesh.normals[0] = {0.0f, 0.6f, 0.8f};  // vertex 0 stays, its faces do not
        what.steps = {{"Hit 1", {{2, {1.0f, 1.0f, -0.1f}}}}, {"Hit 2", {{2, scene.mesh.positions[2]}}}};
        const QString path = scene.path("a.glb");
        QVERIFY(exportGltf(what, path, {.steps = true}));
        const Glb glb(path);
        const QJsonObject primitive =
            glb.item("meshes", 0)[QStringLiteral("primitives")].toArray()[0].toObject();
        const QJsonArray targets = primitive[QStringLiteral("targets")].toArray();
        QCOMPARE(targets.size(), 3);
        std::vector<std::vector<float>> turned;
        for (const QJsonValue& target : targets) {
            turned.push_back(floatsOf(glb, target.toObject()[QStringLiteral("NORMAL")].toInt()));
            QCOMPARE(turned.back().size(), std::size_t{15});
        }
        QVERIFY(qAbs(turned[0][6] - 0.6f) < 1e-6f && qAbs(turned[0][1] - 0.6f) < 1e-6f);
        QVERIFY(qAbs(turned[1][6] - 0.24f) < 1e-5f);  // as far as it went: 0.1 of 0.25
        QVERIFY(turned[1][1] == 0.0f);
        for (std::size_t i = 0; i < 15; ++i) {
            QVERIFY(qAbs(turned[0][i] - turned[1][i] - turned[2][i]) < 1e-6f);
        }
    }

    /// A mesh has sRGB, whichever file it came from.
    void coloursBecomeLight_data() {
        QTest::addColumn<QString>("source");
        QTest::newRow("of an OBJ") << QStringLiteral("a.obj");
        QTest::newRow("of a GLB") << QStringLiteral("b.glb");
    }
    void coloursBecomeLight() {
        QFETCH(QString, source);
        Scene scene;
        const QString path = scene.path("a.glb");
        MeshExport what = scene.mesh.what();
        what.sourcePath = scene.path(source.toLatin1().constData());
        QVERIFY(exportGltf(what, path, {}));
        const Glb glb(path);
        const QJsonObject second =
            glb.item("meshes", 0)[QStringLiteral("primitives")].toArray()[1].toObject();
        const int colours =
            second[QStringLiteral("attributes")].toObject()[QStringLiteral("COLOR_0")].toInt();
        QVERIFY(qAbs(floatsOf(glb, colours)[7] - 0.21404f) < 1e-4f);  // green of the last, 0.5 in sRGB
    }

    void materialsBecomeMetallicRough() {
        Scene scene;
        Material& tin = scene.mesh.original.mesh.materials[1];
        tin.metalRoughness.metalness = 0.75f;
        tin.metalRoughness.roughness = 0.25f;
        tin.metalRoughness.image = 0;
        tin.normalMap.image = 0;
        tin.normalMap.strength = 2.0f;
        const QString path = scene.path("a.glb");
        const Result<QStringList> written = exportGltf(scene.mesh.what(), path, {});
        QVERIFY(written);
        QVERIFY(written.value().join(u' ').contains(QStringLiteral("Nothing has moved")));
        const Glb glb(path);
        const QJsonObject wood = glb.item("materials", 0)[QStringLiteral("pbrMetallicRoughness")].toObject();
        QCOMPARE(wood[QStringLiteral("metallicFactor")].toDouble(), 0.0);
        QVERIFY(qAbs(wood[QStringLiteral("roughnessFactor")].toDouble() - 0.4925) < 1e-3);
        QCOMPARE(glb.item("materials", 0)[QStringLiteral("alphaMode")].toString(), QStringLiteral("OPAQUE"));
        const QJsonObject second = glb.item("materials", 1);
        const QJsonObject surface = second[QStringLiteral("pbrMetallicRoughness")].toObject();
        QCOMPARE(surface[QStringLiteral("metallicFactor")].toDouble(), 0.75);
        QCOMPARE(surface[QStringLiteral("roughnessFactor")].toDouble(), 0.25);
        QVERIFY(surface.contains(QStringLiteral("metallicRoughnessTexture")));
        QCOMPARE(second[QStringLiteral("normalTexture")].toObject()[QStringLiteral("scale")].toDouble(), 2.0);
        QCOMPARE(second[QStringLiteral("alphaMode")].toString(), QStringLiteral("BLEND"));
        // One picture is the file's own bytes, the other the pixels of what has no name.
        const QJsonObject image = glb.item("images", 0);
        const QJsonObject view = glb.item("bufferViews", image[QStringLiteral("bufferView")].toInt());
        QCOMPARE(QByteArray(glb.buffer.data() + view[QStringLiteral("byteOffset")].toInt(),
                            view[QStringLiteral("byteLength")].toInt()),
                 woodPng());
        QCOMPARE(glb.json[QStringLiteral("images")].toArray().size(), 2);
    }

    void filesBesideReplaceNothing() {
        Scene scene;
        scene.dent();
        writeFile(scene.path(""), QStringLiteral("a.bin"), "mine");
        writeFile(scene.path(""), QStringLiteral("wood grain.png"), "mine too");
        const QString path = writeFile(scene.path(""), QStringLiteral("a.gltf"), "old");
        const Result<QStringList> written = exportGltf(scene.mesh.what(), path, {});
        QVERIFY2(written, qPrintable(messageOf(written)));
        QCOMPARE(readFile(scene.path("a.bin")), std::string("mine"));
        QCOMPARE(readFile(scene.path("wood grain.png")), std::string("mine too"));
        QCOMPARE(readFile(scene.path("wood grain-1.png")), woodPng().toStdString());
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(readFile(path))).object();
        QCOMPARE(json[QStringLiteral("buffers")].toArray()[0].toObject()[QStringLiteral("uri")].toString(),
                 QStringLiteral("a-1.bin"));
        QCOMPARE(json[QStringLiteral("images")].toArray()[0].toObject()[QStringLiteral("uri")].toString(),
                 QStringLiteral("wood%20grain-1.png"));
        QVERIFY(verifyWritten(path, scene.mesh.what()));
    }

    void givenUpNothingIsWritten() {
        Scene scene;
        scene.dent();
        for (const char* const name : {"a.glb", "a.gltf"}) {
            for (int looks = 0; looks < 3; ++looks) {
                MeshExport what = scene.mesh.what();
                int left = looks;
                what.goOn = [&left](ExportStep, double) { return left-- > 0; };
                QVERIFY(
                    messageOf(exportGltf(what, scene.path(name), {})).contains(QStringLiteral("cancelled")));
            }
        }
        QCOMPARE(QDir(scene.path("")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList());
    }
};

}  // namespace

HITSCOPE_TEST(TestIoWriteGltf, QCoreApplication)

}  // namespace hitscope::io_write_gltf_test

#include "io_write_gltf_test.moc"
