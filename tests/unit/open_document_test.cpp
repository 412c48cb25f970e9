// SPDX-License-Identifier: GPL-3.0-or-later
// Session > document > file > document > session.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <glm/gtc/quaternion.hpp>
#include <thread>

#include "deform/fingerprint.h"
#include "deform/reference.h"
#include "document/capture.h"
#include "document/document_json.h"
#include "document/open_document.h"
#include "document_support.h"
#include "io/import.h"
#include "io_support.h"
#include "mesh/panel_texture.h"
#include "open_document_support.h"
#include "session/primitive_target.h"
#include "session/sample_scenes.h"
#include "session/session.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"

namespace hitscope::open_document_test {
using namespace test;

class OpenDocumentTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("meshes")));
        m_mesh = writeFile(m_folder->path(), QStringLiteral("meshes/rock.obj"), kObj);
    }
    void sameSession();
    void ownMeshes_data();
    void ownMeshes();
    void placedMesh();
    void sharedMesh();
    void missingMesh();
    void movedMesh();
    void changedMesh();
    void unknownSource();
    void notAMesh();
    void cancelled();
    void onAnotherThread();
    void nothingToUndo();

private:
    void load(Session& session);
    void trySame(const Session& session);

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_mesh;
};

/// The mesh of the file, and a torus.
void OpenDocumentTest::load(Session& session) {
    Result<ImportedMesh> mesh = importMesh(m_mesh);
    QVERIFY2(mesh.ok(), qPrintable(messageOf(mesh)));
    ScenePlan plan;
    plan.name = QStringLiteral("Rock and ring");
    plan.targets = {planMesh(std::move(mesh.value().mesh), m_mesh),
                    planPrimitive({PrimitiveKind::Torus, 24, 2.0f})};
    plan.floorHeight = -0.5f;
    session.loadScene(std::move(plan));
}

/// Written, read and opened it is the same, in all that is kept.
void OpenDocumentTest::trySame(const Session& session) {
    const SessionDocument document = captureSession(session, someView());
    const QByteArray bytes = writeDocument(document);
    Result<PreparedSession> ready = prepared(bytes);
    QVERIFY2(ready.ok(), qPrintable(messageOf(ready)));
    QVERIFY(ready.value().isWhole() && ready.value().troubles.empty());
    Session opened;
    loadTeapot(opened);  // which goes
    restoreSession(opened, ready.value());
    QCOMPARE(hitsFingerprint(opened), hitsFingerprint(session));
    QCOMPARE(referenceFingerprints(opened), referenceFingerprints(session));
    SessionDocument again = captureSession(opened, someView());
    again.positions = document.positions;
    // But for the targets' ids, which the session never had: a file counts them from 1.
    QVERIFY(opened.targets().front()->id != session.targets().front()->id);
    SessionDocument numbered = document;
    numberTargets(1, numbered);
    numberTargets(1, again);
    // The time goes on from the last hit, where hits were made without any passing.
    for (const Hit& hit : document.hits) {
        numbered.simulation.time = std::max(numbered.simulation.time, hit.time);
    }
    QCOMPARE(writeDocument(again), writeDocument(numbered));
    // What a document leaves out is the same in both of them.
    QVERIFY(opened.settings().constantsSetting() == session.settings().constantsSetting());
    QVERIFY(opened.settings().projectile() == session.settings().projectile());
    QVERIFY(opened.settings().flightMode() == session.settings().flightMode());
    QVERIFY(opened.settings().lights() == session.settings().lights());
    QCOMPARE(opened.settings().pipeline(), session.settings().pipeline());
    const StepClock& was = session.simulation().physics().clock();
    const StepClock& is = opened.simulation().physics().clock();
    QVERIFY(is.step() == was.step() && is.timeScale() == was.timeScale() && is.isPaused() == was.isPaused());
    QCOMPARE(opened.sceneName(), session.sceneName());
    QCOMPARE(opened.targets().floorHeight(), session.targets().floorHeight());
    QCOMPARE(opened.hits().selected(), session.hits().selected());
    QCOMPARE(opened.hits().shown().size(), session.hits().shown().size());
    for (std::size_t i = 0; i < session.targets().size(); ++i) {
        const Target& now = *opened.targets()[i];
        const Target& then = *session.targets()[i];
        QCOMPARE(now.name, then.name);
        QCOMPARE(now.visible, then.visible);
        QVERIFY(now.transform.position == then.transform.position);
        QVERIFY(now.transform.rotation == then.transform.rotation);
        QVERIFY(now.physics == then.physics);
        QCOMPARE(opened.targets()[i]->sourcePath, session.targets()[i]->sourcePath);
        QCOMPARE(opened.targets()[i]->collider->index(), session.targets()[i]->collider->index());
    }
}

void OpenDocumentTest::sameSession() {
    Session session;
    load(session);
    shoot(session, 60, 1);
    const TargetId rock = session.targets()[0]->id;
    const TargetId ring = session.targets()[1]->id;
    QVERIFY(session.targets().rename(rock, QStringLiteral("Fels")).ok());
    QVERIFY(session.targets()
                .setTransform(ring, {{1.0f, 2.0f, -0.0f}, glm::angleAxis(0.3f, glm::vec3(0, 1, 0))})
                .ok());
    QVERIFY(session.targets().setPhysics(ring, {true, 7.0f, 0.1f, 0.2f}).ok());
    session.targets().setVisible({&rock, 1}, false);
    session.targets().duplicate({&ring, 1});
    const std::size_t removed = 3;
    session.hits().remove({&removed, 1});
    QVERIFY(session.settings().setConstants(ConstantsSetting{{0.3f, 0.02f, 0.1f}, false}).ok());
    Lights lights = session.settings().lights();
    lights.points[2].on = false;
    lights.spot.innerAngle = 0.1f;
    session.settings().setLights(lights);
    ProjectileSettings projectile;
    projectile.mass = 3.0f;
    projectile.bouncesCount = true;
    session.settings().setProjectile(projectile);
    session.settings().setFlightMode(FlightMode::Own);
    session.settings().setPipeline(PipelineKind::Reference);
    session.settings().setCoverTexture(std::make_shared<const Image>(makePanelTexture(64)));
    session.simulation().setStep(1.0 / 300.0);
    session.simulation().setTimeScale(0.25);
    session.simulation().setPaused(true);
    session.hits().select(7);
    session.hits().show(20);
    session.selection().select(ring, {1, 5, 9}, VertexSelection::Combine::Replace);
    session.selection().setPicked(VertexRef{rock, 2});
    session.targets().select(rock);
    trySame(session);

    // What a person does is what is kept, not how the test came to it.
    const SessionDocument document = captureSession(session, someView());
    QCOMPARE(document.targets.size(), std::size_t(3));
    QCOMPARE(document.scene.coverTexture, 64);
    QCOMPARE(document.simulation.flight, FlightMode::Own);
    QVERIFY(document.simulation.paused);
    QCOMPARE(document.selection.shown, std::optional<std::size_t>(20));
    QVERIFY(std::get<MeshFile>(document.targets[0].source.mesh) == meshFileAt(m_mesh));
    QVERIFY(document.targets[2].source == document.targets[1].source);
    QVERIFY(document.positions.empty());  // nobody has read back what the hits made
}

void OpenDocumentTest::ownMeshes_data() {
    QTest::addColumn<int>("scene");
    QTest::newRow("teapot") << -1;
    for (int row = 0; row < 3; ++row) {
        QTest::addRow("paper %d", row) << row;
    }
    QTest::newRow("turntable") << 100;
    QTest::newRow("wall") << 101;
    for (int kind = 0; kind < 7; ++kind) {
        QTest::addRow("primitive %d", kind) << 200 + kind;
    }
}

void OpenDocumentTest::ownMeshes() {
    QFETCH(int, scene);
    Session session;
    if (scene < 0) {
        loadTeapot(session);
    } else if (scene < 100) {
        loadPaperRow(session, scene);
    } else if (scene < 200) {
        session.loadScene(planSampleScene(static_cast<SampleScene>(scene - 100)));
    } else {
        session.loadScene(
            {QStringLiteral("One"), {planPrimitive({static_cast<PrimitiveKind>(scene - 200), 12, 1.7f})}});
    }
    const SessionDocument before = captureSession(session, someView());
    QCOMPARE(before.positions.size(), session.targets().size());
    shoot(session, 40, 2);
    trySame(session);
    // Without hits the positions are those of the mesh.
    Session opened;
    Result<PreparedSession> ready = prepareSession(before, {});
    QVERIFY(ready.ok());
    restoreSession(opened, ready.value());
    QVERIFY(differingTargets(opened, before).empty());
    QVERIFY(captureSession(opened, someView()).positions == before.positions);
}

void OpenDocumentTest::placedMesh() {
    for (const bool isFile : {true, false}) {
        Session session;
        MeshData mesh = isFile ? std::move(importMesh(m_mesh).value().mesh)
                               : *planPrimitive({PrimitiveKind::Sheet, 6, 1.0f}).shape.mesh;
        place(mesh, 3.3f);
        const TargetSource source = isFile ? TargetSource(meshFileAt(m_mesh))
                                           : TargetSource(Primitive{PrimitiveKind::Sheet, 6, 1.0f});
        session.loadScene({QStringLiteral("Placed"), {planMesh(prepareMesh(std::move(mesh)), source)}});
        shoot(session, 20, 3);
        QVERIFY(!captureSession(session, {}).targets[0].placement.isIdentity());
        trySame(session);
    }
}

/// Ten copies cost one mesh.
void OpenDocumentTest::sharedMesh() {
    Session session;
    load(session);
    const TargetId ids[] = {session.targets()[0]->id, session.targets()[1]->id};
    session.targets().duplicate(ids);
    Result<PreparedSession> ready = prepareSession(captureSession(session, {}), {});
    QVERIFY(ready.ok());
    const auto& targets = ready.value().scene.targets;
    QCOMPARE(targets.size(), std::size_t(4));
    QCOMPARE(targets[0].shape.mesh, targets[2].shape.mesh);
    QCOMPARE(targets[1].shape.render, targets[3].shape.render);
    QVERIFY(targets[0].shape.mesh != targets[1].shape.mesh);
}

void OpenDocumentTest::missingMesh() {
    Session session;
    load(session);
    const TargetId rock = session.targets()[0]->id;
    session.targets().duplicate({&rock, 1});
    shoot(session, 30, 4);
    session.hits().select(2);
    const QByteArray bytes = writeDocument(captureSession(session, {}));
    const QString elsewhere = m_folder->filePath(QStringLiteral("stone.obj"));
    QVERIFY(QFile::rename(m_mesh, elsewhere));

    Result<PreparedSession> without = prepared(bytes);
    QVERIFY(without.ok());
    QVERIFY(!without.value().isWhole());
    QCOMPARE(without.value().troubles.size(), std::size_t(1));
    const MeshTrouble& trouble = without.value().troubles[0];
    QCOMPARE(trouble.kind, MeshTrouble::Kind::Missing);
    QCOMPARE(trouble.path, m_mesh);
    QCOMPARE(trouble.targets.size(), std::size_t(2));
    QCOMPARE(trouble.hits, std::size_t(20));
    QVERIFY(!trouble.error.what.empty() && !trouble.error.advice.empty());
    Session opened;
    restoreSession(opened, without.value());
    QCOMPARE(opened.targets().size(), std::size_t(1));
    QCOMPARE(opened.hits().history().size(), std::size_t(10));
    QVERIFY(!opened.hits().selected());

    MeshPlaces places;
    places.found[m_mesh] = elsewhere;
    Result<PreparedSession> with = prepared(bytes, places);
    QVERIFY(with.ok() && with.value().isWhole() && with.value().troubles.empty());
    restoreSession(opened, with.value());
    QCOMPARE(hitsFingerprint(opened), hitsFingerprint(session));
    QCOMPARE(referenceFingerprints(opened), referenceFingerprints(session));
    QCOMPARE(opened.targets()[0]->sourcePath, elsewhere);
}

/// With its session into another folder, or to where another one was found.
void OpenDocumentTest::movedMesh() {
    Session session;
    load(session);
    SessionDocument document = captureSession(session, {});
    nameFilesFrom(m_folder->path(), document);
    QCOMPARE(document.targets[0].source.relativePath, QStringLiteral("meshes/rock.obj"));
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("other")));
    QVERIFY(QFile::rename(m_folder->filePath(QStringLiteral("meshes")),
                          m_folder->filePath(QStringLiteral("other/meshes"))));
    QVERIFY(!prepareSession(document, {}).value().isWhole());
    MeshPlaces places;
    places.folder = m_folder->filePath(QStringLiteral("other"));
    QVERIFY(prepareSession(document, places).value().isWhole());
    MeshPlaces known;
    known.others = {m_folder->filePath(QStringLiteral("other/meshes"))};
    QVERIFY(prepareSession(document, known).value().isWhole());
    // Of several, that with the content that is wanted.
    writeFile(m_folder->filePath(QStringLiteral("other")), QStringLiteral("rock.obj"),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    known.others.prepend(m_folder->filePath(QStringLiteral("other")));
    Result<PreparedSession> right = prepareSession(document, known);
    QVERIFY(right.value().troubles.empty());
    QCOMPARE(right.value().scene.targets[0].sourcePath,
             m_folder->filePath(QStringLiteral("other/meshes/rock.obj")));
}

void OpenDocumentTest::changedMesh() {
    Session session;
    load(session);
    const SessionDocument document = captureSession(session, {});
    QCOMPARE(document.positions.size(), std::size_t(2));
    writeFile(m_folder->path(), QStringLiteral("meshes/rock.obj"),
              QByteArray(kObj).replace("0.7", "0.8").toStdString());
    Result<PreparedSession> ready = prepareSession(document, {});
    QVERIFY(ready.ok() && ready.value().isWhole());
    QCOMPARE(ready.value().troubles.size(), std::size_t(1));
    QCOMPARE(ready.value().troubles[0].kind, MeshTrouble::Kind::Changed);
    Session opened;
    restoreSession(opened, ready.value());
    QCOMPARE(opened.targets().size(), std::size_t(2));
    const std::vector<TargetId> differing = differingTargets(opened, document);
    QCOMPARE(differing.size(), std::size_t(1));
    QCOMPARE(differing[0], opened.targets()[0]->id);
    // Which of the other mesh's triangles its hits struck is not known.
    shoot(session, 10, 9);
    ready = prepareSession(captureSession(session, {}), {});
    QVERIFY(ready.ok());
    restoreSession(opened, ready.value());
    QCOMPARE(opened.hits().history().size(), std::size_t(10));
    for (const Hit& hit : opened.hits().history().hits()) {
        QCOMPARE(hit.triangle, hit.target == opened.targets()[0]->id ? kNoIndex : 77u);
    }
}

void OpenDocumentTest::unknownSource() {
    Session session;
    session.loadScene({QStringLiteral("?"), {planMesh(*planPrimitive({}).shape.mesh)}});
    shoot(session, 3, 5);
    Result<PreparedSession> ready = prepared(writeDocument(captureSession(session, {})));
    QVERIFY(ready.ok() && !ready.value().isWhole());
    QCOMPARE(ready.value().troubles[0].kind, MeshTrouble::Kind::NotKnown);
    QCOMPARE(ready.value().troubles[0].hits, std::size_t(3));
    Session opened;
    restoreSession(opened, ready.value());
    QVERIFY(opened.targets().empty());
}

void OpenDocumentTest::notAMesh() {
    Session session;
    load(session);
    const SessionDocument document = captureSession(session, {});
    writeFile(m_folder->path(), QStringLiteral("meshes/rock.obj"), "Dear reader,\n");
    Result<PreparedSession> ready = prepareSession(document, {});
    QVERIFY(ready.ok() && !ready.value().isWhole());
    QVERIFY(ready.value().troubles[0].error.message().find("There are no vertices in it") !=
            std::string::npos);
}

void OpenDocumentTest::cancelled() {
    Session session;
    load(session);
    std::atomic<bool> isOver = true;
    int told = 0;
    const PrepareControl control{[&told](double, const QString&) { ++told; }, &isOver};
    const SessionDocument document = captureSession(session, {});
    Result<PreparedSession> ready = prepareSession(document, {}, control);
    QVERIFY(messageOf(ready).contains(QStringLiteral("cancelled")));
    QCOMPARE(told, 0);
    isOver = false;
    QVERIFY(prepareSession(document, {}, control).ok());
    QVERIFY(told >= 2);
}

void OpenDocumentTest::onAnotherThread() {
    Session session;
    load(session);
    shoot(session, 10, 6);
    const SessionDocument document = captureSession(session, {});
    std::optional<Result<PreparedSession>> ready;
    std::thread([&] { ready.emplace(prepareSession(document, {})); }).join();
    QVERIFY2(ready->ok(), qPrintable(messageOf(*ready)));
    Session opened;
    restoreSession(opened, ready->value());
    QCOMPARE(referenceFingerprints(opened), referenceFingerprints(session));
}

void OpenDocumentTest::nothingToUndo() {
    Session session;
    load(session);
    shoot(session, 10, 7);
    Result<PreparedSession> ready = prepareSession(captureSession(session, {}), {});
    restoreSession(session, ready.value());
    QVERIFY(!session.steps().canUndo() && !session.steps().canRedo());
    // What comes next goes on from there.
    shoot(session, 1, 8);
    QCOMPARE(session.hits().history().size(), std::size_t(11));
    session.undo();
    QCOMPARE(session.hits().history().size(), std::size_t(10));
}

HITSCOPE_TEST(OpenDocumentTest, QCoreApplication)
}  // namespace hitscope::open_document_test
#include "open_document_test.moc"
