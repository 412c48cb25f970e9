// SPDX-License-Identifier: GPL-3.0-or-later
// Every pipeline moves vertices that no face uses, as the reference does.
#include <QTest>
#include <random>

#include "analysis/reference_agreement.h"
#include "deform/reference.h"
#include "gl/pipeline_rows.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::unreferenced_vertices_test {

namespace {

constexpr std::size_t kLoose = 700;

MeshData sphereWithLooseVertices() {
    MeshData mesh = makeUvSphere(24, 12, 2.5f);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> coordinate(-2.6f, 2.6f);
    for (std::size_t i = 0; i < kLoose; ++i) {
        const float x = coordinate(random);
        const float y = coordinate(random);
        mesh.positions.emplace_back(x, y, coordinate(random));
    }
    return mesh;
}

}  // namespace

class UnreferencedVerticesGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void areMoved_data() { test::addPipelines(); }
    void areMoved() {
        QFETCH(int, kind);
        Session session;
        loadMesh(session, sphereWithLooseVertices());
        Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        if (!session.readBack().whyUnavailable(static_cast<PipelineKind>(kind)).isEmpty()) {
            QSKIP("this renderer has no such pipeline");
        }
        if (static_cast<PipelineKind>(kind) != PipelineKind::Reference) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        shootAll(session, demoShots(session, 40, 5));
        QVERIFY(session.hits().history().size() > 30);
        QVERIFY(gpu.value()->sync());
        const DeformedMesh& mesh = session.targets()[0]->deformed;
        PageVector<DynamicVertex> should = mesh.render().vertices;
        deformEverywhere(should, session.hits().history().hits());
        std::size_t looseMoved = 0;
        for (std::uint32_t v = 0; v < mesh.original().vertexCount(); ++v) {
            const std::uint32_t r = mesh.render().renderVerticesOf(v).front();
            QVERIFY(mesh.positions()[v] == should[r].position);
            looseMoved += v + kLoose >= mesh.original().vertexCount() && mesh.isChanged(v) ? 1 : 0;
        }
        QVERIFY(looseMoved > 20);
        QVERIFY(agreementWithReference(session, ReferenceMethod::Clusters).isExact());
        session.undo();
        session.hits().clear();
        QVERIFY(gpu.value()->sync());
        QCOMPARE(mesh.statistics().changedVertices, std::size_t{0});
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(UnreferencedVerticesGlTest, QCoreApplication)

}  // namespace hitscope::unreferenced_vertices_test

#include "unreferenced_vertices_test.moc"
