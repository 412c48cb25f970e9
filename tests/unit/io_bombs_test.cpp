// SPDX-License-Identifier: GPL-3.0-or-later
#include <assimp/scene.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <utility>

#include "io/import.h"
#include "io/readers/assimp_check.h"
#include "io/readers/gltf_prepare.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_bombs_test {

using namespace test;

class BombsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void gltf_data();
    void gltf();
    void triangleOpens();
    void daeIsRefused_data();
    void daeIsRefused();
    void daeOpens_data();
    void daeOpens();
    void fbx_data();
    void fbx();
    void arraysShorterThanTheySay();
    void otherFormatsUnderTheSuffix();
    void instancesCountAsOftenAsTheyAre();
    void tellsWhatItLeavesOut();
    void followsALinkToTheMesh();

private:
    [[nodiscard]] QString write(const char* name, const std::string& content) const {
        return writeFile(m_folder.path(), QString::fromLatin1(name), content);
    }
    QTemporaryDir m_folder;
};

namespace {

/// A triangle as glTF, whose parts tests replace.
struct Gltf {
    std::string scene = R"([{"nodes":[0]}])";
    std::string nodes = R"([{"mesh":0}])";
    std::string primitive = R"({"attributes":{"POSITION":0}})";
    std::string accessors = R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}])";
    std::string views = R"([{"buffer":0,"byteLength":36}])";
    std::string more;  ///< of the members

    [[nodiscard]] std::string text() const {
        std::string numbers;
        put(numbers, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f);
        return R"({"asset":{"version":"2.0"},"scene":0,"scenes":)" + scene + R"(,"nodes":)" + nodes +
               R"(,"meshes":[{"primitives":[)" + primitive + R"(]}],"accessors":)" + accessors +
               R"(,"bufferViews":)" + views + more +
               R"(,"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
               QByteArray::fromStdString(numbers).toBase64().toStdString() + "\"}]}";
    }
};

/// Nodes each of which has the next one twice.
std::string doublingNodes(int steps) {
    std::string nodes = "[";
    for (int n = 1; n <= steps; ++n) {
        nodes += "{\"children\":[" + std::to_string(n) + "," + std::to_string(n) + "]},";
    }
    return nodes + R"({"mesh":0}])";
}

/// A triangle as COLLADA; `nodes` are its library's, of which the scene has "n0".
std::string dae(const std::string& nodes) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset/><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0
</float_array><technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_nodes>)" +
           nodes + R"(</library_nodes><library_visual_scenes><visual_scene id="s"><node id="r">
<instance_node url="#n0"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

std::string doublingInstances(int steps) {
    std::string nodes;
    for (int n = 0; n < steps; ++n) {
        const std::string next = "<instance_node url=\"#n" + std::to_string(n + 1) + "\"/>";
        nodes += "<node id=\"n" + std::to_string(n) + "\">" + next + next + "</node>";
    }
    return nodes + "<node id=\"n" + std::to_string(steps) + "\"><instance_geometry url=\"#g\"/></node>";
}

}  // namespace

/// Small files that ask for very much, or for what is not theirs.
void BombsTest::gltf_data() {
    QTest::addColumn<Gltf>("file");
    QTest::addColumn<QString>("message");
    using Change = std::function<void(Gltf&)>;
    const auto row = [](const char* title, const char* message, const Change& change) {
        Gltf file;
        change(file);
        QTest::newRow(title) << file << message;
    };
    row("nodes that double", "node 1 has two parents", [](Gltf& f) { f.nodes = doublingNodes(24); });
    row("a circle", "has a parent, or stands in the scene twice",
        [](Gltf& f) { f.nodes = R"([{"children":[1]},{"mesh":0,"children":[0]}])"; });
    row("a root twice", "has a parent, or stands in the scene twice",
        [](Gltf& f) { f.scene = R"([{"nodes":[0,0]}])"; });
    row("a count of nothing", "accessor 0 promises 350000000 values, of which the file holds none",
        [](Gltf& f) { f.accessors = R"([{"componentType":5126,"count":350000000,"type":"VEC3"}])"; });
    row("a count that some replace", "accessor 0 promises 350000000 values", [](Gltf& f) {
        f.accessors = R"([{"componentType":5126,"count":350000000,"type":"VEC3","sparse":{"count":1,)"
                      R"("indices":{"bufferView":0,"componentType":5125},"values":{"bufferView":0}}}])";
    });
    row("a count beyond the numbers", "accessor 0 goes on behind the end of its buffer view",
        [](Gltf& f) { f.accessors = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}])"; });
    row("an offset beyond them", "accessor 0 goes on behind the end of its buffer view", [](Gltf& f) {
        f.accessors = R"([{"bufferView":0,"byteOffset":4,"componentType":5126,"count":3,"type":"VEC3"}])";
    });
    row("a view beyond the buffer", "buffer view 0 goes on behind the end of its buffer",
        [](Gltf& f) { f.views = R"([{"buffer":0,"byteOffset":4,"byteLength":36}])"; });
    row("a negative count", "its count is no number of things",
        [](Gltf& f) { f.accessors = R"([{"bufferView":0,"componentType":5126,"count":-3,"type":"VEC3"}])"; });
    row("a mesh that is not there", "it refers to a mesh that it does not have",
        [](Gltf& f) { f.nodes = R"([{"mesh":7}])"; });
    row("a negative accessor", "it refers to an accessor that it does not have",
        [](Gltf& f) { f.primitive = R"({"attributes":{"POSITION":-1}})"; });
    row("fewer normals than vertices", "the attributes of a mesh have different lengths", [](Gltf& f) {
        f.primitive = R"({"attributes":{"POSITION":0,"NORMAL":1}})";
        f.accessors.insert(f.accessors.size() - 1,
                           R"(,{"bufferView":0,"componentType":5126,"count":1,"type":"VEC3"})");
    });
    row("too few for a strip", "a mesh has fewer vertices than one of its faces", [](Gltf& f) {
        f.primitive = R"({"attributes":{"POSITION":0},"mode":5,"indices":1})";
        f.accessors.insert(f.accessors.size() - 1,
                           R"(,{"bufferView":0,"componentType":5125,"count":1,"type":"SCALAR"})");
    });
    row("an index too large", "1 of its 2 triangles refer to vertices that it does not have", [](Gltf& f) {
        f.primitive = R"({"attributes":{"POSITION":0},"indices":1})";
        f.accessors.insert(f.accessors.size() - 1,
                           R"(,{"bufferView":0,"componentType":5125,"count":6,"type":"SCALAR"})");
    });
    row("a matrix that divides by zero", "Its matrix does not place anything",
        [](Gltf& f) { f.nodes = R"([{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,0]}])"; });
    row("no coordinate", "A coordinate is infinite or not a number",
        [](Gltf& f) { f.nodes = R"([{"scale":[1e30,1,1],"children":[1]},{"mesh":0,"scale":[1e30,1,1]}])"; });
    row("no JSON", "its JSON is wrong at byte", [](Gltf& f) { f.more = ",,"; });
}

void BombsTest::gltf() {
    QFETCH(Gltf, file);
    QFETCH(QString, message);
    const QString text = messageOf(importMesh(write("a.gltf", file.text())));
    QVERIFY2(text.contains(message), qPrintable(text));
}

void BombsTest::triangleOpens() {
    const Result<ImportedMesh> result = importMesh(write("a.gltf", Gltf().text()));
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    QCOMPARE(result.value().mesh.faceCount(), std::size_t(1));
    QCOMPARE(result.value().notes, QStringList());
}

void BombsTest::daeIsRefused_data() {
    QTest::addColumn<QString>("nodes");
    QTest::addColumn<QString>("message");
    QTest::newRow("instances that double")
        << QString::fromStdString(doublingInstances(24)) << "more nodes or vertices than can be opened";
    QTest::newRow("a circle") << "<node id=\"n0\"><instance_node url=\"#n1\"/></node>"
                                 "<node id=\"n1\"><instance_node url=\"#n0\"/></node>"
                              << "a node is an instance of what it is in";
    QTest::newRow("in itself") << "<node id=\"n0\"><node><instance_node url=\"#n0\"/></node></node>"
                               << "a node is an instance of what it is in";
    QTest::newRow("no XML") << "<node id=\"n0\">"
                            << "a.dae, line 7: It cannot be read as DAE:";
}

void BombsTest::daeIsRefused() {
    QFETCH(QString, nodes);
    QFETCH(QString, message);
    const QString text = messageOf(importMesh(write("a.dae", dae(nodes.toStdString()))));
    QVERIFY2(text.contains(message), qPrintable(text));
}

void BombsTest::daeOpens_data() {
    QTest::addColumn<QString>("nodes");
    QTest::addColumn<int>("triangles");
    QTest::newRow("once") << QString::fromStdString(doublingInstances(0)) << 1;
    QTest::newRow("eight times") << QString::fromStdString(doublingInstances(3)) << 8;
    // The instance is of the library's node, not of the one in the scene that has its name.
    QTest::newRow("same name") << "<node id=\"n0\" name=\"n1\"><instance_node url=\"#n1\"/></node>"
                                  "<node id=\"n1\" name=\"n0\"><instance_geometry url=\"#g\"/></node>"
                               << 1;
}

void BombsTest::daeOpens() {
    QFETCH(QString, nodes);
    QFETCH(int, triangles);
    const Result<ImportedMesh> result = importMesh(write("a.dae", dae(nodes.toStdString())));
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    QCOMPARE(result.value().mesh.faceCount(), static_cast<std::size_t>(triangles));
}

void BombsTest::fbx_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("steps");
    QTest::addColumn<bool>("circle");
    QTest::addColumn<QString>("message");
    QTest::newRow("models that double") << "a.fbx" << 24 << false << "more nodes than can be opened";
    QTest::newRow("a circle") << "a.fbx" << 2 << true << "a model is a part of itself";
    QTest::newRow("eight times") << "a.fbx" << 3 << false << "no error";
}

/// The quad of the test data, below models each of which stands twice in the one before.
void BombsTest::fbx() {
    QFETCH(QString, name);
    QFETCH(int, steps);
    QFETCH(bool, circle);
    QFETCH(QString, message);
    std::string text = readFile(QStringLiteral(HITSCOPE_TEST_DATA "/quad.fbx"));
    std::string models;
    std::string links = "C: \"OO\",5000,0\n";
    const auto link = [&links](int child, int parent) {
        links += "\tC: \"OO\"," + std::to_string(child) + "," + std::to_string(parent) + "\n";
    };
    for (int n = 0; n <= steps; ++n) {
        models += "\tModel: " + std::to_string(5000 + n) + ", \"Model::m\", \"Null\" {\n\t}\n";
        for (int twice = 0; twice < 2 && n < steps; ++twice) {
            link(5001 + n, 5000 + n);
        }
    }
    link(2000, 5000 + steps);
    if (circle) {
        link(5000, 5000 + steps);
    }
    text.replace(text.find("C: \"OO\",2000,0\n"), 16, links);
    text.insert(text.find("\tMaterial: 3000"), models);
    const Result<ImportedMesh> result = importMesh(write(qPrintable(name), text));
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
    QVERIFY(!result || result.value().mesh.faceCount() == std::size_t{2} << steps);
}

/// As Assimp's readers leave them behind for some broken files.
void BombsTest::arraysShorterThanTheySay() {
    aiMesh mesh;
    aiMesh* meshes[] = {&mesh};
    aiNode root;
    aiScene scene;
    scene.mMeshes = meshes;
    scene.mNumMeshes = 1;
    scene.mRootNode = &root;
    mesh.mVertices = new aiVector3D[3];
    mesh.mNumVertices = 3;
    mesh.mFaces = new aiFace[2];
    mesh.mNumFaces = 2;
    mesh.mFaces[1].mIndices = new unsigned[3]{0, 1, 2};
    mesh.mFaces[1].mNumIndices = 3;
    QVERIFY(checkScene(scene).ok());
    for (unsigned* const count : {&mesh.mNumVertices, &mesh.mNumFaces, &mesh.mFaces[1].mNumIndices}) {
        const unsigned right = std::exchange(*count, 1000);
        QVERIFY(!checkScene(scene).ok());
        *count = right;
    }
    mesh.mNormals = new aiVector3D[1];
    mesh.mNumVertices = 30;
    QVERIFY(!checkScene(scene).ok());
    mesh.mNumVertices = 3;
    scene.mMeshes = nullptr;  // they are not on the heap
    scene.mNumMeshes = 0;
    scene.mRootNode = nullptr;
}

/// Assimp would look for a reader that wants the content, whatever the suffix.
void BombsTest::otherFormatsUnderTheSuffix() {
    const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const char* const name : {"a.gltf", "a.glb", "a.dae", "a.fbx", "a.3ds"}) {
        QVERIFY2(!importMesh(write(name, off)), name);
    }
}

/// Each instance is modest; together they are not.
void BombsTest::instancesCountAsOftenAsTheyAre() {
    Gltf file;
    file.accessors = R"([{"bufferView":0,"componentType":5126,"count":60000,"type":"VEC3"}])";
    file.views = R"([{"buffer":0,"byteLength":720000}])";
    std::string nodes = "[";
    std::string roots = "[{\"nodes\":[";
    for (int n = 0; n < 1000; ++n) {
        nodes += R"({"mesh":0},)";
        roots += std::to_string(n) + ",";
    }
    nodes.back() = ']';
    roots.pop_back();
    file.nodes = nodes;
    file.scene = roots + "]}]";
    std::string text = file.text();
    text.replace(text.find("\"byteLength\":36,"), 16, "\"byteLength\":720000,");
    const std::string filled = text + std::string(720000, ' ');  // so long that it may hold the numbers
    const Result<PreparedGltf> prepared = prepareGltf(filled, m_folder.path());
    QVERIFY2(messageOf(prepared).contains(QStringLiteral("more vertices than can be opened")),
             qPrintable(messageOf(prepared)));
    QVERIFY(!prepareGltf(text, m_folder.path()).ok());
}

void BombsTest::tellsWhatItLeavesOut() {
    Gltf file;
    file.nodes = R"([{"mesh":0,"translation":[5,0,0]}])";
    file.more = R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)"
                R"("samplers":[{"input":1,"output":0}]}])";
    file.accessors.insert(file.accessors.size() - 1,
                          R"(,{"bufferView":0,"componentType":5126,"count":3,"type":"SCALAR"})");
    const Result<ImportedMesh> result = importMesh(write("a.gltf", file.text()));
    QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    QCOMPARE(result.value().notes,
             QStringList{QStringLiteral("Animations, bones and morph targets were left out.")});
    QCOMPARE(result.value().mesh.positions.at(1), glm::vec3(6, 0, 0));
}

/// The mesh itself may lie elsewhere, whatever reads it.
void BombsTest::followsALinkToTheMesh() {
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("links")));
    for (const char* const name : {"b.gltf", "b.off"}) {
        const QString file =
            write(name, QByteArray(name).endsWith("off") ? "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
                                                         : Gltf().text());
        const QString link = m_folder.filePath(QStringLiteral("links/") + QString::fromLatin1(name));
        QVERIFY(QFile::link(file, link));
        const Result<ImportedMesh> result = importMesh(link);
        QVERIFY2(result.ok(), qPrintable(messageOf(result)));
    }
}

HITSCOPE_TEST(BombsTest, QCoreApplication)

}  // namespace hitscope::io_bombs_test

#include "io_bombs_test.moc"
