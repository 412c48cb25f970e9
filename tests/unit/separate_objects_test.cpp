// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a file as targets of their own: nothing of the mesh is lost, and its dents stay as they are.
#include "session/mesh_steps/separate_objects.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <string>
#include <vector>

#include "deform/reference.h"
#include "document/capture.h"
#include "document/document_json.h"
#include "document/open_document.h"
#include "io/readers/obj_reader.h"
#include "mesh/mesh_objects.h"
#include "mesh/primitives.h"
#include "mesh/same_bits.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/session.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"

namespace hitscope::separate_objects_test {

namespace {

MeshData meshOf(const std::string& obj) {
    Result<ImportedMesh> read = parseObjInParts(obj, 1);
    return read ? std::move(read.value().mesh) : MeshData();
}

/// Three objects, the first without a name, of which two share a vertex; a line, a point and a vertex of
/// none.
const char* const kThree =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 9 9 9\nv 8 8 8\n"
    "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 1 0\n"
    "g inner\nusemtl red\nf 1/1/1 2/2/1 3/3/1\n"
    "o empty\no second\nusemtl blue\nf 4//2 5//2 6//2\nl 5 8\np 6\n"
    "o second\ng tip\nf 6 5 4\n"
    "o third\nusemtl red\nf 2 4 5\n";

/// Two spheres 0.2 m apart, with a hit between them, one on each, one far away, one on the first that is off.
class Scene {
public:
    Scene() {
        const MeshData ball = makeUvSphere(24, 12, 1.0f);
        MeshData both = ball;
        both.groups = {{FaceGroup::Kind::Object, "left", 0},
                       {FaceGroup::Kind::Object, "right", static_cast<std::uint32_t>(ball.faceCount())}};
        const auto vertices = static_cast<std::uint32_t>(ball.vertexCount());
        const auto normals = static_cast<std::uint32_t>(ball.normals.size());
        const auto texcoords = static_cast<std::uint32_t>(ball.texcoords.size());
        const auto corners = static_cast<std::uint32_t>(ball.cornerVertices.size());
        for (const glm::vec3& position : ball.positions) {
            both.positions.push_back(position + glm::vec3(2.2f, 0.0f, 0.0f));
        }
        for (std::size_t face = 1; face < ball.faceStarts.size(); ++face) {
            both.faceStarts.push_back(ball.faceStarts[face] + corners);
        }
        const auto add = [](const auto& all, auto& list, std::uint32_t by) {
            for (const std::uint32_t index : all) {
                list.push_back(index == kNoIndex ? index : index + by);
            }
        };
        add(ball.cornerVertices, both.cornerVertices, vertices);
        add(ball.cornerNormals, both.cornerNormals, normals);
        add(ball.cornerTexcoords, both.cornerTexcoords, texcoords);
        both.normals.insert(both.normals.end(), ball.normals.begin(), ball.normals.end());
        both.texcoords.insert(both.texcoords.end(), ball.texcoords.begin(), ball.texcoords.end());
        both.faceMaterials.clear();
        both.faceSmoothing.clear();
        both.materials.clear();
        loadMesh(m_session, std::move(both));
        hit({1.1f, 0.4f, 0.0f}, true);
        hit({0.0f, 1.0f, 0.0f}, true);
        hit({2.2f, 1.0f, 0.0f}, true);
        hit({-0.9f, 0.4f, 0.0f}, false);
        hit({50.0f, 0.0f, 0.0f}, true);
        hit({1.1f, 0.5f, 0.0f}, true);
    }
    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] const Target& target(std::size_t index) const { return *m_session.targets()[index]; }
    [[nodiscard]] Result<SeparatedObjects> objects() const {
        return separated(target(0), meshEdit(m_session, target(0).id, {}).hits);
    }
    void hit(const glm::vec3& point, bool enabled) {
        Hit hit;
        hit.target = target(0).id;
        hit.point = point;
        hit.direction = {0.1f, -1.0f, 0.0f};
        hit.constants = {0.6f, 0.1f, 0.4f};
        hit.enabled = enabled;
        QVERIFY(m_session.hits().add(hit).ok());
    }

private:
    Session m_session;
};

/// The dented shape by the mesh's vertices.
std::vector<glm::vec3> shape(const Session& session, const Target& target) {
    ReferenceDeformation dented(*target.shape.render);
    dented.apply(session.hits().history().hitsOn(target.id));
    const PageVector<glm::vec3>& original = target.shape.mesh->positions;
    std::vector<glm::vec3> positions(original.begin(), original.end());
    for (std::size_t v = 0; v < dented.vertices().size(); ++v) {
        positions[target.shape.render->fileVertices[v]] = dented.vertices()[v].position;
    }
    return positions;
}

}  // namespace

class SeparateObjectsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void objectsAreWhatTheFileNames();
    void objectsHaveWhatTheyUse();
    void onlyMeshesWithSeveral();
    void dentsStayInEveryBit();
    void isOneStepToUndo();
    void selectedVerticesStaySelected();
    void hitsThatChangedMeanwhileAreNotDistributed();
    void sessionsKeepParts();
};

void SeparateObjectsTest::objectsAreWhatTheFileNames() {
    const MeshData mesh = meshOf(kThree);
    const MeshObjects objects(mesh);
    QCOMPARE(objects.count(), std::size_t(3));
    QCOMPARE(objectCount(mesh), std::size_t(3));
    QCOMPARE(objects.name(0), std::string());
    QCOMPARE(objects.name(1), std::string("second"));
    QCOMPARE(objects.name(2), std::string("third"));
    using Vertices = std::vector<std::uint32_t>;
    QCOMPARE(objects.vertices(0), (Vertices{0, 1, 2, 6}));
    QCOMPARE(objects.vertices(1), (Vertices{3, 4, 5, 7}));
    QCOMPARE(objects.vertices(2), (Vertices{1, 3, 4}));
    std::size_t faces = 0;
    for (std::size_t i = 0; i < objects.count(); ++i) {
        const MeshData part = objects.only(i);
        QVERIFY2(validate(part).ok(), validate(part) ? "" : validate(part).error().message().c_str());
        QCOMPARE(part.sourceVertices, objects.vertices(i));
        for (std::size_t v = 0; v < part.vertexCount(); ++v) {
            QVERIFY(sameBits(part.positions[v], mesh.positions[part.sourceVertices[v]]));
        }
        faces += part.faceCount();
    }
    QCOMPARE(faces, mesh.faceCount());
    MeshData whole = mesh;
    whole.groups.clear();
    QCOMPARE(objectCount(whole), std::size_t(1));
    QCOMPARE(objectCount(MeshData()), std::size_t(0));
}

void SeparateObjectsTest::objectsHaveWhatTheyUse() {
    const MeshData mesh = meshOf(kThree);
    const MeshObjects objects(mesh);
    const MeshData first = objects.only(0);
    QCOMPARE(first.texcoords.size(), std::size_t(3));
    QCOMPARE(first.normals.size(), std::size_t(1));
    QCOMPARE(first.materials.size(), std::size_t(1));
    QCOMPARE(first.materials[0].name, std::string("red"));
    QCOMPARE(first.groups.size(), std::size_t(1));
    QCOMPARE(first.groups[0].name, std::string("inner"));

    const MeshData second = objects.only(1);
    QCOMPARE(second.name, std::string("second"));
    QCOMPARE(second.faceCount(), std::size_t(2));
    QVERIFY(second.texcoords.empty());
    QCOMPARE(second.normals.size(), std::size_t(1));
    QVERIFY(second.normals[0] == glm::vec3(0.0f, 1.0f, 0.0f));
    QCOMPARE(second.materials.size(), std::size_t(1));
    QCOMPARE(second.materials[0].name, std::string("blue"));
    QCOMPARE(second.lines.size(), std::size_t(1));
    QCOMPARE(second.lines[0], (std::vector<std::uint32_t>{1, 3}));
    QCOMPARE(second.points, (std::vector<std::uint32_t>{2}));
    QCOMPARE(second.groups.size(), std::size_t(3));
    QCOMPARE(second.groups[0].name, std::string("second"));
    QCOMPARE(second.groups[1].name, std::string("inner"));
    QCOMPARE(second.groups[2].name, std::string("tip"));
    QCOMPARE(second.groups[2].firstFace, 1U);

    // A part of a part keeps the file's numbers.
    MeshData again = second;
    again.groups.push_back({FaceGroup::Kind::Object, "last", 1});
    const MeshData last = MeshObjects(again).only(1);
    QCOMPARE(last.sourceVertices, (std::vector<std::uint32_t>{3, 4, 5}));
}

void SeparateObjectsTest::onlyMeshesWithSeveral() {
    Session session;
    loadMesh(session, makeLowPolyCube());
    QVERIFY(!separated(*session.targets().front(), {}).ok());
    QVERIFY(!withStep(*session.targets().front()->shape.mesh, OnlyObject{1}).ok());
    Scene scene;
    int looks = 0;
    QVERIFY(!separated(scene.target(0), {}, [&looks](double) { return ++looks < 2; }).ok());
}

void SeparateObjectsTest::dentsStayInEveryBit() {
    Scene scene;
    const std::vector<glm::vec3> before = shape(scene.session(), scene.target(0));
    const Result<SeparatedObjects> objects = scene.objects();
    QVERIFY(objects.ok());
    using Parts = std::vector<std::uint32_t>;
    QCOMPARE(objects.value().partsOfHit, (std::vector<Parts>{{0, 1}, {0}, {1}, {0}, {1}, {0, 1}}));
    QVERIFY(takeSeparated(scene.session(), objects.value()).ok());
    QCOMPARE(scene.session().targets().size(), std::size_t(2));
    QCOMPARE(scene.session().hits().history().size(), std::size_t(8));
    std::size_t moved = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const Target& part = scene.target(i);
        const std::vector<glm::vec3> now = shape(scene.session(), part);
        for (std::size_t v = 0; v < now.size(); ++v) {
            const std::uint32_t source = part.shape.mesh->sourceVertices[v];
            QVERIFY(sameBits(now[v], before[source]));
            moved += sameBits(now[v], part.shape.mesh->positions[v]) ? 0 : 1;
        }
    }
    QVERIFY(moved > 40);
    QCOMPARE(scene.target(0).name, QStringLiteral("left"));
    QCOMPARE(scene.target(1).name, QStringLiteral("right"));
    QCOMPARE(scene.session().targets().selected(), scene.target(0).id);
}

void SeparateObjectsTest::isOneStepToUndo() {
    Scene scene;
    Session& session = scene.session();
    // Another target, with a hit among the others, stays as it is.
    session.targets().add({planMesh(makeLowPolyCube())});
    Hit other = session.hits().history().hits()[1];
    other.target = scene.target(1).id;
    QVERIFY(session.hits().add(other).ok());
    session.hits().move(std::vector<std::size_t>{6}, 1);
    const std::vector<Hit> hits(session.hits().history().hits().begin(),
                                session.hits().history().hits().end());
    const RigidTransform where{{1.0f, 2.0f, 3.0f}, {0.6f, 0.0f, 0.8f, 0.0f}};
    QVERIFY(session.targets().setTransform(scene.target(0).id, where).ok());
    const std::size_t steps = session.steps().done();
    const Result<SeparatedObjects> objects = scene.objects();
    QVERIFY(objects.ok() && takeSeparated(session, objects.value()).ok());
    QCOMPARE(session.steps().done(), steps + 1);
    QCOMPARE(session.steps().toUndo()->kind, SessionUndo::Kind::SeparateObjects);
    QCOMPARE(session.targets().size(), std::size_t(3));
    for (std::size_t part = 0; part < 2; ++part) {
        QVERIFY(scene.target(part).transform.position == where.position);
        QVERIFY(glm::dot(scene.target(part).transform.rotation, where.rotation) > 0.9999f);
    }
    QCOMPARE(scene.target(2).id, other.target);
    QCOMPARE(session.hits().history().hits()[2].target, other.target);
    const std::vector<Hit> after(session.hits().history().hits().begin(),
                                 session.hits().history().hits().end());
    session.undo();
    QCOMPARE(session.targets().size(), std::size_t(2));
    QVERIFY(std::equal(hits.begin(), hits.end(), session.hits().history().hits().begin(),
                       session.hits().history().hits().end()));
    session.redo();
    QCOMPARE(session.targets().size(), std::size_t(3));
    QVERIFY(std::equal(after.begin(), after.end(), session.hits().history().hits().begin(),
                       session.hits().history().hits().end()));
}

void SeparateObjectsTest::selectedVerticesStaySelected() {
    Scene scene;
    const auto vertices = static_cast<std::uint32_t>(scene.target(0).shape.mesh->vertexCount());
    scene.session().selection().select(scene.target(0).id, {3, vertices - 1},
                                       VertexSelection::Combine::Replace);
    const Result<SeparatedObjects> objects = scene.objects();
    QVERIFY(objects.ok() && takeSeparated(scene.session(), objects.value()).ok());
    const auto selected = [&scene](std::size_t index) {
        const auto chosen = scene.session().selection().vertices(scene.target(index).id);
        return std::vector<std::uint32_t>(chosen.begin(), chosen.end());
    };
    QCOMPARE(selected(0), (std::vector<std::uint32_t>{3}));
    QCOMPARE(selected(1), (std::vector<std::uint32_t>{vertices / 2 - 1}));
}

void SeparateObjectsTest::hitsThatChangedMeanwhileAreNotDistributed() {
    Scene scene;
    const Result<SeparatedObjects> objects = scene.objects();
    QVERIFY(objects.ok());
    scene.hit({0.0f, 1.0f, 0.0f}, true);
    QVERIFY(!takeSeparated(scene.session(), objects.value()).ok());
    QCOMPARE(scene.session().targets().size(), std::size_t(1));
    scene.session().undo();
    QVERIFY(takeSeparated(scene.session(), objects.value()).ok());
    QVERIFY(!takeSeparated(scene.session(), objects.value()).ok());  // the target is gone
}

void SeparateObjectsTest::sessionsKeepParts() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("three.obj"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(kThree) > 0);
    file.close();
    Session session;
    loadMesh(session, meshOf(kThree), path);
    const Result<SeparatedObjects> objects = separated(*session.targets().front(), {});
    QVERIFY(objects.ok() && takeSeparated(session, objects.value()).ok());
    const QByteArray bytes = writeDocument(captureSession(session, {}));
    QVERIFY(bytes.contains("only-object"));
    Result<SessionDocument> read = readDocument(bytes);
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
    QCOMPARE(writeDocument(read.value()), bytes);
    Result<PreparedSession> prepared = prepareSession(std::move(read).value(), {});
    QVERIFY(prepared.ok() && prepared.value().isWhole());
    Session other;
    restoreSession(other, prepared.value());
    QCOMPARE(other.targets().size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(other.targets()[i]->name, session.targets()[i]->name);
        QCOMPARE(other.targets()[i]->shape.mesh->sourceVertices,
                 session.targets()[i]->shape.mesh->sourceVertices);
        QCOMPARE(other.targets()[i]->shape.mesh->cornerVertices,
                 session.targets()[i]->shape.mesh->cornerVertices);
    }
}

HITSCOPE_TEST(SeparateObjectsTest, QCoreApplication)

}  // namespace hitscope::separate_objects_test

#include "separate_objects_test.moc"
