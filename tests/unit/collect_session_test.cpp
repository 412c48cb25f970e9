// SPDX-License-Identifier: GPL-3.0-or-later
// A session and all that it refers to, in one folder.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "document/collect_session.h"
#include "document/session_file.h"
#include "io/import.h"
#include "io/pending_files.h"
#include "mesh/missing_textures.h"
#include "open_document_support.h"
#include "session/primitive_target.h"
#include "support/test_program.h"

namespace hitscope::collect_session_test {

using namespace test;

namespace {

SavedTarget meshTarget(std::uint32_t id, const QString& path, std::vector<LocatedTexture> textures = {}) {
    SavedTarget target;
    target.id = TargetId{id};
    target.source.mesh = MeshFile{path};
    target.textures = std::move(textures);
    return target;
}

QStringList placesOf(const Collection& collection) {
    QStringList places;
    for (const CollectedFile& file : collection.files) {
        places << file.place;
    }
    places.sort();
    return places;
}

QString sourceOf(const Collection& collection, const QString& place) {
    for (const CollectedFile& file : collection.files) {
        if (file.place == place) {
            return file.source;
        }
    }
    return {};
}

/// All files below, with what is in them.
std::map<QString, std::string> contentsOf(const QString& folder) {
    std::map<QString, std::string> contents;
    QDirIterator it(folder, QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        const QString path = it.next();
        contents[QDir(folder).relativeFilePath(path)] = readFile(path);
    }
    return contents;
}

using Kind = MeshReference::Kind;

}  // namespace

class CollectSessionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup() { m_session.reset(); }
    void eachMeshHasItsPlace();
    void namesKeepTheirWay();
    void locatedTextures();
    void opensAnywhere();
    void namesOfAnyBytes();
    void filesOfGltf();
    void goneMeshesAreNamed();
    void changedMeshesAreNamed();
    void nothingIsReplaced();
    void cancelledLeavesNothing();
    void endedLeavesNothing();
    void whatIsMissingIsTold();

private:
    [[nodiscard]] QString in(const QString& name) const { return m_folder->filePath(name); }
    void write(const QString& name, std::string_view content) const {
        const QFileInfo info(in(name));
        QVERIFY(QDir().mkpath(info.absolutePath()));
        writeFile(info.absolutePath(), info.fileName(), content);
    }
    TargetPlan plan(const QString& name) const {
        const Result<ImportedMesh> mesh = importMesh(in(name));
        if (!mesh) {
            qWarning("%s", mesh.error().message().c_str());
        }
        return mesh ? planMesh(mesh.value().mesh, in(name)) : TargetPlan();
    }
    [[nodiscard]] MeshesByPath meshes() const {
        MeshesByPath meshes;
        for (const auto& target : m_session->targets()) {
            meshes[target->sourcePath] = target->shape.mesh;
        }
        return meshes;
    }
    Result<QStringList> collect(const PrepareControl& control = {}) const {
        return collectSession(captureSession(*m_session, {}), meshes(), in(QStringLiteral("out")),
                              QStringLiteral("one.hitscope"), control);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Session> m_session;
};

/// Two rocks of the same name with materials of the same name, which differ.
void CollectSessionTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    const QByteArray png = smallPng();
    const std::string_view picture(png.constData(), static_cast<std::size_t>(png.size()));
    const std::string head = "mtllib lib/rock.mtl\nusemtl stone\n";
    write(QStringLiteral("a/rock.obj"), head + kObj);
    write(QStringLiteral("a/lib/rock.mtl"), "newmtl stone\nKd 1 0 0\nmap_Kd maps/grey.png\n");
    write(QStringLiteral("a/maps/grey.png"), picture);
    write(QStringLiteral("b/rock.obj"), head + kObj + "f 1 3 5\n");
    write(QStringLiteral("b/lib/rock.mtl"), "newmtl stone\nKd 0 1 0\nmap_Kd C:\\tex\\grey.png\n");
    write(QStringLiteral("b/grey.png"), picture);
    m_session = std::make_unique<Session>();
    ScenePlan scene;
    scene.name = QStringLiteral("Rocks");
    scene.targets = {plan(QStringLiteral("a/rock.obj")), plan(QStringLiteral("b/rock.obj")),
                     planPrimitive({PrimitiveKind::Torus, 24, 2.0f})};
    m_session->loadScene(std::move(scene));
    const TargetId first = m_session->targets().front()->id;
    m_session->targets().duplicate({&first, 1});
    shoot(*m_session, 40, 5);
    QCOMPARE(m_session->targets()[0]->shape.mesh->images.size(), std::size_t{1});
    QCOMPARE(m_session->targets()[1]->shape.mesh->images.size(), std::size_t{1});
}

void CollectSessionTest::eachMeshHasItsPlace() {
    SessionDocument document;
    document.targets = {
        meshTarget(1, QStringLiteral("/x/rock.obj")), meshTarget(2, QStringLiteral("/y/rock.obj")),
        meshTarget(3, QStringLiteral("/x/rock.obj")), meshTarget(4, QStringLiteral("/x/moon.ply")),
        meshTarget(5, QStringLiteral("/z/Rock.stl"))};
    SavedTarget own;
    own.source.mesh = BuiltInMesh::Teapot;
    document.targets.push_back(own);
    const Collection collection = planCollection(document, {});
    QCOMPARE(placesOf(collection),
             (QStringList{QStringLiteral("meshes/Rock-3/Rock.stl"), QStringLiteral("meshes/rock-2/rock.obj"),
                          QStringLiteral("meshes/rock/moon.ply"), QStringLiteral("meshes/rock/rock.obj")}));
    QCOMPARE(sourceOf(collection, QStringLiteral("meshes/rock-2/rock.obj")), QStringLiteral("/y/rock.obj"));
    const std::vector<SavedTarget>& targets = collection.document.targets;
    QCOMPARE(targets[2].source.relativePath, QStringLiteral("meshes/rock/rock.obj"));
    QCOMPARE(std::get<MeshFile>(targets[1].source.mesh).path, QStringLiteral("meshes/rock-2/rock.obj"));
    QVERIFY(std::holds_alternative<BuiltInMesh>(targets[5].source.mesh));
    QVERIFY(collection.notes.isEmpty());
}

void CollectSessionTest::namesKeepTheirWay() {
    SessionDocument document;
    document.targets = {meshTarget(1, QStringLiteral("/x/rock.obj"))};
    const ReferencesByMesh references = {
        {QStringLiteral("/x/rock.obj"),
         {
             {QStringLiteral("./lib//rock.mtl"), QStringLiteral("/x/lib/rock.mtl"), Kind::Data},
             {QStringLiteral("maps\\a.png"), QStringLiteral("/x/maps/a.png"), Kind::Picture},
             {QStringLiteral("link/b.png"), QStringLiteral("/x/really/b.png"), Kind::Picture},
             {QStringLiteral("/x/maps/c.png"), QStringLiteral("/x/maps/c.png"), Kind::Picture},
             {QStringLiteral("../x/d.png"), QStringLiteral("/x/d.png"), Kind::Picture},
             {QStringLiteral("C:\\tex\\e.png"), QStringLiteral("/x/e.png"), Kind::PictureByName},
             {QStringLiteral("old/f.png"), QStringLiteral("/x/f.png"), Kind::PictureByName},
             // Neither can be found again.
             {QStringLiteral("/x/lib/g.mtl"), QStringLiteral("/x/lib/g.mtl"), Kind::Data},
             {QStringLiteral("/x/maps/d.png"), QStringLiteral("/x/maps/d.png"), Kind::Picture},
         }}};
    const Collection collection = planCollection(document, references);
    QStringList expected;
    for (const char* place :
         {"c.png", "d.png", "e.png", "f.png", "lib/rock.mtl", "link/b.png", "maps/a.png", "rock.obj"}) {
        expected << QStringLiteral("meshes/rock/") + QLatin1String(place);
    }
    QCOMPARE(placesOf(collection), expected);
    QCOMPARE(sourceOf(collection, QStringLiteral("meshes/rock/link/b.png")),
             QStringLiteral("/x/really/b.png"));
    QCOMPARE(sourceOf(collection, QStringLiteral("meshes/rock/d.png")), QStringLiteral("/x/d.png"));
    QCOMPARE(collection.notes.size(), 2);
    QVERIFY(collection.notes[0].contains(QStringLiteral("/x/lib/g.mtl")));
    QVERIFY(collection.notes[1].contains(QStringLiteral("/x/maps/d.png")));
}

void CollectSessionTest::locatedTextures() {
    SessionDocument document;
    document.targets = {
        meshTarget(1, QStringLiteral("/x/rock.obj"), {{"a.png", QStringLiteral("/p/wood.png")}}),
        meshTarget(2, QStringLiteral("/y/moon.obj"),
                   {{"b.png", QStringLiteral("/q/wood.png")}, {"c.png", QStringLiteral("/p/wood.png")}})};
    const Collection collection = planCollection(document, {});
    const auto& first = collection.document.targets[0].textures;
    const auto& second = collection.document.targets[1].textures;
    QVERIFY(first == (std::vector<LocatedTexture>{{"a.png", QStringLiteral("textures/wood.png"),
                                                   QStringLiteral("textures/wood.png")}}));
    QCOMPARE(second[0].relativePath, QStringLiteral("textures/wood-2.png"));
    QCOMPARE(second[1].relativePath, QStringLiteral("textures/wood.png"));
    QCOMPARE(sourceOf(collection, QStringLiteral("textures/wood-2.png")), QStringLiteral("/q/wood.png"));
    QCOMPARE(collection.files.size(), std::size_t{4});
}

void CollectSessionTest::opensAnywhere() {
    const Result<QStringList> collected = collect();
    QVERIFY2(collected.ok(), qPrintable(messageOf(collected)));
    QCOMPARE(collected.value(), QStringList());
    for (const char* original : {"a", "b"}) {
        QVERIFY(QDir(in(QLatin1String(original))).removeRecursively());
    }
    QVERIFY(QDir(m_folder->path()).rename(QStringLiteral("out"), QStringLiteral("elsewhere")));
    const QString file = in(QStringLiteral("elsewhere/one.hitscope"));
    QVERIFY(!QString::fromStdString(readFile(file)).contains(m_folder->path()));
    Result<SessionDocument> document = readSessionFile(file);
    QVERIFY2(document.ok(), qPrintable(messageOf(document)));
    MeshPlaces places;
    places.folder = in(QStringLiteral("elsewhere"));
    Result<PreparedSession> ready = prepareSession(document.value(), places);
    QVERIFY2(ready.ok(), qPrintable(messageOf(ready)));
    QVERIFY(ready.value().troubles.empty());
    QCOMPARE(ready.value().notes, QStringList());
    Session opened;
    restoreSession(opened, ready.value());
    QCOMPARE(hitsFingerprint(opened), hitsFingerprint(*m_session));
    QCOMPARE(referenceFingerprints(opened), referenceFingerprints(*m_session));
    for (std::size_t i = 0; i < 2; ++i) {
        const MeshData& mesh = *opened.targets()[i]->shape.mesh;
        QVERIFY(missingTextures(mesh).empty());
        QCOMPARE(mesh.images.size(), std::size_t{1});
        QVERIFY(mesh.materials[0].diffuse == m_session->targets()[i]->shape.mesh->materials[0].diffuse);
    }
}

/// In Latin-1, as older programs wrote them.
void CollectSessionTest::namesOfAnyBytes() {
    const std::string name =
        "M\xf6"
        "bel";
    const QByteArray png = smallPng();
    const std::string library = "newmtl a\nmap_Kd " + name + ".png\n";
    write(QStringLiteral("l/Möbel.png"), png.toStdString());
    write(QStringLiteral("l/Möbel.mtl"), library);
    write(QStringLiteral("l/mesh.obj"), "mtllib " + name + ".mtl\nusemtl a\n" + kObj);
    m_session->targets().add({plan(QStringLiteral("l/mesh.obj"))});
    QCOMPARE(m_session->targets().back()->shape.mesh->images.size(), std::size_t{1});
    const Result<QStringList> collected = collect();
    QVERIFY2(collected.ok(), qPrintable(messageOf(collected)));
    QCOMPARE(readFile(in(QStringLiteral("out/meshes/mesh/Möbel.mtl"))), library);
    QCOMPARE(readFile(in(QStringLiteral("out/meshes/mesh/Möbel.png"))), png.toStdString());
}

void CollectSessionTest::filesOfGltf() {
    std::string buffer;
    put(buffer, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f);
    const std::string picture = smallPng().toStdString();
    write(QStringLiteral("g/data/a tri.bin"), buffer);
    write(QStringLiteral("g/maps/a map.png"), picture);
    write(QStringLiteral("g/tri.gltf"),
          R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "data/a%20tri.bin", "byteLength": 36}],
              "bufferViews": [{"buffer": 0, "byteLength": 36}],
              "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                             "min": [0, 0, 0], "max": [1, 1, 0]}],
              "images": [{"uri": "maps/a%20map.png"}], "textures": [{"source": 0}],
              "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
              "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
              "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0})");
    m_session->targets().add({plan(QStringLiteral("g/tri.gltf"))});
    QCOMPARE(m_session->targets().back()->shape.mesh->vertexCount(), std::size_t{3});
    QVERIFY(collect().ok());
    QCOMPARE(readFile(in(QStringLiteral("out/meshes/tri/data/a tri.bin"))), buffer);
    QCOMPARE(readFile(in(QStringLiteral("out/meshes/tri/maps/a map.png"))), picture);
    const Result<ImportedMesh> copy = importMesh(in(QStringLiteral("out/meshes/tri/tri.gltf")));
    QVERIFY2(copy.ok(), qPrintable(messageOf(copy)));
    QCOMPARE(copy.value().mesh.images.size(), std::size_t{1});
}

void CollectSessionTest::goneMeshesAreNamed() {
    QVERIFY(QFile::remove(in(QStringLiteral("a/rock.obj"))));
    const Result<QStringList> collected = collect();
    QVERIFY(!collected.ok());
    QVERIFY2(messageOf(collected).contains(in(QStringLiteral("a/rock.obj"))),
             qPrintable(messageOf(collected)));
    QVERIFY(!messageOf(collected).contains(in(QStringLiteral("b/rock.obj"))));
    QVERIFY(!QFileInfo::exists(in(QStringLiteral("out"))));
}

void CollectSessionTest::changedMeshesAreNamed() {
    write(QStringLiteral("b/rock.obj"), kObj);
    const Result<QStringList> collected = collect();
    QVERIFY(!collected.ok());
    QVERIFY2(messageOf(collected).contains(in(QStringLiteral("b/rock.obj"))),
             qPrintable(messageOf(collected)));
    QVERIFY(!QFileInfo::exists(in(QStringLiteral("out"))));
}

void CollectSessionTest::nothingIsReplaced() {
    write(QStringLiteral("out/other.txt"), "mine");
    for (const char* taken : {"out/one.hitscope", "out/meshes/rock/rock.obj"}) {
        write(QLatin1String(taken), "mine too");
        const auto before = contentsOf(in(QStringLiteral("out")));
        const Result<QStringList> collected = collect();
        QVERIFY(!collected.ok());
        QVERIFY(messageOf(collected).contains(QLatin1String(taken).mid(0, 10)));
        QVERIFY(contentsOf(in(QStringLiteral("out"))) == before);
        QVERIFY(QFile::remove(in(QLatin1String(taken))));
    }
    QVERIFY(QDir(in(QStringLiteral("out/meshes"))).removeRecursively());
    // A link would lead out of the folder.
    QVERIFY(QDir().mkpath(in(QStringLiteral("mine"))));
    QVERIFY(QFile::link(in(QStringLiteral("mine")), in(QStringLiteral("out/meshes"))));
    QVERIFY(!collect().ok());
    QVERIFY(contentsOf(in(QStringLiteral("mine"))).empty());
    QVERIFY(QFile::remove(in(QStringLiteral("out/meshes"))));
    QVERIFY(collect().ok());
    QCOMPARE(readFile(in(QStringLiteral("out/other.txt"))), std::string("mine"));
    QVERIFY(!collect().ok());  // it is there now
}

void CollectSessionTest::cancelledLeavesNothing() {
    std::atomic<bool> cancelled = false;
    PrepareControl control;
    control.cancelled = &cancelled;
    int steps = 0;
    control.progress = [&](double fraction, const QString&) {
        QVERIFY(fraction <= 1.0);
        cancelled = ++steps == 4;
    };
    const Result<QStringList> collected = collect(control);
    QVERIFY(!collected.ok());
    QVERIFY(messageOf(collected).contains(QStringLiteral("cancelled")));
    QVERIFY(!QFileInfo::exists(in(QStringLiteral("out"))));
    QCOMPARE(steps, 4);
}

/// As where a signal ends the program.
void CollectSessionTest::endedLeavesNothing() {
    PrepareControl control;
    int steps = 0;
    control.progress = [&](double, const QString&) {
        if (++steps == 4) {
            QVERIFY(QFileInfo::exists(in(QStringLiteral("out/meshes"))));
            removePendingFiles();
            QVERIFY(!QFileInfo::exists(in(QStringLiteral("out"))));
        }
    };
    QVERIFY(!collect(control).ok());
    QVERIFY(steps >= 4);
    // Later folders are not its own.
    QVERIFY(QDir().mkpath(in(QStringLiteral("out"))));
    removePendingFiles();
    QVERIFY(QFileInfo::exists(in(QStringLiteral("out"))));
}

void CollectSessionTest::whatIsMissingIsTold() {
    QVERIFY(QFile::remove(in(QStringLiteral("a/maps/grey.png"))));
    m_session->targets().add({plan(QStringLiteral("a/rock.obj"))});
    SessionDocument document = captureSession(*m_session, {});
    document.targets[1].textures = {{"x.png", in(QStringLiteral("gone/x.png"))}};
    const Result<QStringList> collected =
        collectSession(document, meshes(), in(QStringLiteral("out")), QStringLiteral("one.hitscope"));
    QVERIFY2(collected.ok(), qPrintable(messageOf(collected)));
    QCOMPARE(collected.value().size(), 2);
    QVERIFY(collected.value().join(u'\n').contains(QStringLiteral("maps/grey.png")));
    QVERIFY(collected.value().join(u'\n').contains(QStringLiteral("gone/x.png")));
}

HITSCOPE_TEST(CollectSessionTest, QCoreApplication)

}  // namespace hitscope::collect_session_test

#include "collect_session_test.moc"
