// SPDX-License-Identifier: GPL-3.0-or-later
// The session followed on the GPU: what the CPU copy holds after every kind of change equals the reference.
#include "scene/scene_gpu.h"

#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <glm/geometric.hpp>

#include "deform/reference.h"
#include "gl/pipeline_rows.h"
#include "io/import.h"
#include "mesh/primitives.h"
#include "session/export/export_target.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_gpu_test {

namespace {

std::size_t differences(const Session& session) {
    std::size_t count = 0;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        ReferenceDeformation reference(target->deformed.render());
        reference.apply(session.hits().history().hitsOn(target->id));
        for (std::size_t i = 0; i < reference.vertices().size(); ++i) {
            const DynamicVertex& is = target->deformed.vertices()[i];
            const DynamicVertex& should = reference.vertices()[i];
            count += is.position != should.position || is.normal != should.normal ? 1 : 0;
        }
    }
    return count;
}

std::size_t changed(const Session& session) {
    std::size_t count = 0;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        count += target->deformed.statistics().changedVertices;
    }
    return count;
}

}  // namespace

class SceneGpuTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void followsEveryChangeOfTheHistory_data() { test::addPipelines(); }
    void followsEveryChangeOfTheHistory() {
        QFETCH(int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        SceneGpu& gpu = *made.value();

        const auto synced = [&] { return gpu.sync().ok() && differences(session) == 0; };
        QVERIFY(synced());
        shootAll(session, demoShots(session, 40, 3));
        QVERIFY(session.hits().history().size() > 30);
        QVERIFY(synced());
        QVERIFY(changed(session) > 100);

        session.undo();
        session.undo();
        QVERIFY(synced());
        session.redo();
        QVERIFY(synced());
        session.hits().remove(4);
        QVERIFY(synced());
        DeformationConstants constants;
        constants.maxDistance = 0.8f;
        constants.power = 0.08f;
        QVERIFY(session.settings().setConstants(constants));
        session.hits().giveConstantsToAll();
        QVERIFY(synced());
        QVERIFY(session.settings().setConstants(DeformationConstants{}));
        shootAll(session, demoShots(session, 10, 4));
        QVERIFY(synced());
        session.hits().clear();
        QVERIFY(synced());
        QCOMPARE(changed(session), std::size_t{0});
        session.undo();
        QVERIFY(synced());
        loadTeapot(session);
        QVERIFY(synced());
        shootAll(session, demoShots(session, 20, 5));
        QVERIFY(synced());
        QVERIFY(changed(session) > 100);
    }

    void followsEveryChangeOfTheTargets_data() { followsEveryChangeOfTheHistory_data(); }
    void followsEveryChangeOfTheTargets() {
        QFETCH(int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        SceneGpu& gpu = *made.value();
        const auto synced = [&] { return gpu.sync().ok() && differences(session) == 0; };
        shootAll(session, demoShots(session, 40, 3));
        QVERIFY(synced());
        const std::size_t dented = changed(session);
        const TargetId first = session.targets()[0]->id;
        const TargetId last = session.targets()[15]->id;
        QVERIFY(!session.hits().history().hitsOn(first).empty());

        session.targets().remove(std::array{first, last});
        QVERIFY(synced());
        QVERIFY(changed(session) < dented);
        session.undo();
        QVERIFY(synced());
        QCOMPARE(changed(session), dented);
        // Gone and back between two frames.
        session.targets().remove(std::array{first});
        session.undo();
        QVERIFY(synced());
        QCOMPARE(changed(session), dented);
        session.targets().duplicate(std::array{first});
        QVERIFY(synced());
        QVERIFY(changed(session) > dented);
        session.targets().reset(std::array{first});
        QVERIFY(synced());
        session.undo();
        session.undo();
        session.targets().remove(std::array{last});
        session.targets().add({planMesh(makeHighPolySphere())});
        QVERIFY(synced());
        session.undo();
        session.undo();
        QVERIFY(synced());
        QCOMPARE(changed(session), dented);
    }

    void switchingPipelinesKeepsEveryBit() {
        Session session;
        loadTeapot(session);
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        shootAll(session, demoShots(session, 60, 11));
        for (int round = 0; round < 3; ++round) {
            for (const PipelineTraits& traits : allPipelines()) {
                if (whyUnavailable(traits.kind)) {
                    continue;
                }
                session.settings().setPipeline(traits.kind);
                QVERIFY(made.value()->sync());
                QCOMPARE(differences(session), std::size_t{0});
            }
        }
    }

    void trueNormalsReturnToTheOriginalOnUndo() {
        Session session;
        loadMesh(session, makeHighPolySphere());
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        QVERIFY(made.value()->sync());
        const Target& target = *session.targets()[0];
        const std::vector<glm::vec3> before = target.trueNormals.normals().all();
        Hit headOn;
        headOn.target = target.id;
        headOn.point = {0, 0, 2.5f};
        headOn.direction = {0, 0, -1};
        QVERIFY(session.hits().add(headOn));
        QVERIFY(made.value()->sync());
        QVERIFY(!std::equal(before.begin(), before.end(), target.trueNormals.normals().all().begin()));
        session.undo();
        QVERIFY(made.value()->sync());
        QVERIFY(std::equal(before.begin(), before.end(), target.trueNormals.normals().all().begin()));
    }

    void exportedMeshReadsBackTheSame() {
        QTemporaryDir folder;
        Session session;
        loadTeapot(session);
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        shootAll(session, demoShots(session, 30, 2));
        QVERIFY(made.value()->sync());
        const Target& target = *session.targets()[0];
        const QString path = folder.filePath(QStringLiteral("deformed.obj"));
        for (const NormalMode normals : {NormalMode::True, NormalMode::Paper}) {
            const auto status = exportTarget(session, target, path, {.normals = normals});
            QVERIFY2(status.ok(), status.ok() ? "" : status.error().message().c_str());
            const Result<ImportedMesh> back = importMesh(path);
            QVERIFY2(back.ok(), back.ok() ? "" : back.error().message().c_str());
            const MeshData& mesh = back.value().mesh;
            const MeshData& original = target.deformed.original();
            QVERIFY(std::equal(mesh.positions.begin(), mesh.positions.end(),
                               target.deformed.positions().begin(), target.deformed.positions().end()));
            QCOMPARE(mesh.faceStarts, original.faceStarts);
            QCOMPARE(mesh.cornerVertices, original.cornerVertices);
            QCOMPARE(mesh.cornerTexcoords, original.cornerTexcoords);
            for (std::size_t corner = 0; corner < mesh.cornerNormals.size(); ++corner) {
                const std::uint32_t vertex = target.deformed.render().cornerRenderVertices[corner];
                const glm::vec3 expected = normals == NormalMode::True
                                               ? target.trueNormals.normals()[vertex]
                                               : target.deformed.vertices()[vertex].normal;
                // A file's own normal is kept where it only differs by not being of unit length to the last
                // bit.
                const glm::vec3 written = glm::normalize(mesh.normals[mesh.cornerNormals[corner]]);
                QVERIFY(glm::distance(written, expected) < 2e-6f);
            }
        }
    }

    /// A mesh that was brought before the session has it is that of its targets, and one that never comes
    /// goes.
    void meshesAreBroughtBeforeTheirTargets() {
        Session session;
        loadTeapot(session);
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        SceneGpu& gpu = *made.value();
        QVERIFY(gpu.sync());
        const PreparedMesh coming = prepareMesh(makeUvSphere(300, 200, 1.0f));
        const PreparedMesh never = prepareMesh(makeUvSphere(20, 20, 1.0f));
        while (!gpu.bring(coming.mesh, coming.render)) {
        }
        QVERIFY(gpu.bring(coming.mesh, coming.render));
        QVERIFY(!gpu.bring(never.mesh, never.render));  // begun
        QCOMPARE(never.render.use_count(), coming.render.use_count());
        loadMesh(session, coming, QString());
        gpu.dropUnusedMeshes();
        QVERIFY(never.render.use_count() < coming.render.use_count());
        for (int frame = 0; frame < 2; ++frame) {
            QVERIFY(gpu.sync());
            QCOMPARE(differences(session), std::size_t{0});
            shootAll(session, demoShots(session, 10, 4));
        }
        QVERIFY(gpu.sync());
        QVERIFY(changed(session) > 0);
        QCOMPARE(differences(session), std::size_t{0});
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(SceneGpuTest, QCoreApplication)

}  // namespace hitscope::scene_gpu_test

#include "scene_gpu_test.moc"
