// SPDX-License-Identifier: GPL-3.0-or-later
// Many new hits at once: some are applied in each frame, and all together are what the reference makes of
// them.
#include <QTest>
#include <glm/geometric.hpp>

#include "deform/reference.h"
#include "deform/scattered_hits.h"
#include "gl/pipeline_rows.h"
#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/task_list.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::sliced_hits_test {

namespace {

constexpr std::size_t kMany = 3000;

std::vector<Hit> scatteredOver(const Session& session, std::size_t count) {
    const Target& target = *session.targets().front();
    ScatterPlan plan;
    plan.count = static_cast<std::uint32_t>(count);
    plan.cone = 0.3;
    Hit model;
    model.target = target.id;
    model.constants = {.maxDistance = 0.4f, .power = 0.002f, .maxMagnitude = 0.02f};
    return scatteredHits({target.deformed.render(), target.deformed.positions(), {}}, plan, model)
        .value()
        .hits;
}

std::size_t wrongVertices(const Session& session) {
    const Target& target = *session.targets().front();
    ReferenceDeformation reference(target.deformed.render());
    reference.apply(session.hits().history().hitsOn(target.id));
    std::size_t count = 0;
    for (std::size_t i = 0; i < reference.vertices().size(); ++i) {
        count += reference.vertices()[i].position != target.deformed.vertices()[i].position ? 1 : 0;
    }
    return count;
}

std::size_t changedVertices(const Session& session) {
    const Target& target = *session.targets().front();
    std::size_t count = 0;
    for (std::size_t i = 0; i < target.deformed.vertices().size(); ++i) {
        count +=
            target.deformed.vertices()[i].position != target.deformed.render().vertices[i].position ? 1 : 0;
    }
    return count;
}

}  // namespace

class SlicedHitsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (!m_gl.open()) {
            return;
        }
        HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        m_target.emplace(64, 48);
        QVERIFY(m_target->isComplete());
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_target.reset(); }

    void manyNewHitsComeOverSeveralFrames_data() {
        QTest::addColumn<PipelineKind>("kind");
        for (const PipelineKind kind :
             {PipelineKind::TransformFeedback, PipelineKind::Compute, PipelineKind::Reference}) {
            QTest::newRow(std::string(pipelineTraits(kind).key).c_str()) << kind;
        }
    }
    void manyNewHitsComeOverSeveralFrames() {
        QFETCH(PipelineKind, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        begin(kind);
        QVERIFY(m_session->hits().addGroup(HitGroupKind::Scatter, scatteredOver(*m_session, kMany)).ok());
        QVERIFY(draw());
        QVERIFY(m_session->tasks().current() != nullptr);  // no frame applies so many
        QVERIFY(m_gpu->isReadBackPending());
        int frames = 1;
        for (; m_gpu->isReadBackPending() && frames < 5000; ++frames) {
            QVERIFY(draw());
        }
        QVERIFY(frames > 5);
        QCOMPARE(m_session->tasks().current(), nullptr);
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});
    }

    void manyNewHitsNeedNoFrames() {
        begin(PipelineKind::TransformFeedback);
        QVERIFY(!m_gpu->isFarBehind());
        QVERIFY(m_session->hits().add(scatteredOver(*m_session, kMany)).ok());
        QVERIFY(draw());
        for (int slice = 0; m_gpu->isBehind() && slice < 5000; ++slice) {
            QVERIFY(m_gpu->applyMore().ok());
        }
        QCOMPARE(m_session->tasks().current(), nullptr);
        QVERIFY(!m_gpu->isReadBackPending());
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});
    }

    void picturesLeaveHitsToTheSlicesBetweenThem_data() { manyNewHitsComeOverSeveralFrames_data(); }
    void picturesLeaveHitsToTheSlicesBetweenThem() {
        QFETCH(PipelineKind, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        begin(kind);
        m_gpu->setAppliesBetweenPictures(true);
        QVERIFY(m_session->hits().addGroup(HitGroupKind::Scatter, scatteredOver(*m_session, kMany)).ok());
        QVERIFY(m_gpu->isFarBehind());
        for (int frame = 0; frame < 3; ++frame) {
            QVERIFY(draw());
        }
        QVERIFY(m_gpu->isFarBehind());
        QCOMPARE(changedVertices(*m_session), std::size_t{0});
        int slices = 0;
        for (; (m_gpu->isBehind() || m_gpu->isFarBehind()) && slices < 5000; ++slices) {
            QVERIFY(m_gpu->applyMore().ok());
        }
        QVERIFY(slices > 5);
        for (int frame = 0; frame < 1 || (m_gpu->isReadBackPending() && frame < 1000); ++frame) {
            QVERIFY(draw());  // what moved follows in slices of time, too, on a busy machine in several
        }
        QVERIFY(!m_gpu->isReadBackPending());
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});

        m_session->undo();
        for (slices = 0; (m_gpu->isBehind() || m_gpu->isFarBehind()) && slices < 5000; ++slices) {
            QVERIFY(m_gpu->applyMore().ok());
        }
        QVERIFY(draw());
        QCOMPARE(m_session->hits().history().size(), std::size_t{0});
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});
    }

    void fewHitsComeWithThePicture() {
        begin(PipelineKind::TransformFeedback);
        m_gpu->setAppliesBetweenPictures(true);
        QVERIFY(m_session->hits().add(scatteredOver(*m_session, 3)).ok());
        QVERIFY(!m_gpu->isFarBehind());
        for (int frame = 0; frame < 2 || (m_gpu->isReadBackPending() && frame < 50); ++frame) {
            QVERIFY(draw());
        }
        QVERIFY(changedVertices(*m_session) > 0);
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});
    }

    void whoNeedsThemNowDoesNotWaitForFrames() {
        begin(PipelineKind::TransformFeedback);
        QVERIFY(m_session->hits().add(scatteredOver(*m_session, kMany)).ok());
        QVERIFY(draw());
        QVERIFY(m_gpu->sync());
        QCOMPARE(m_session->tasks().current(), nullptr);
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});
    }

    void editsAndUndoMeanwhileAreFollowed() {
        begin(PipelineKind::TransformFeedback);
        QVERIFY(m_session->hits().add(scatteredOver(*m_session, kMany)).ok());
        QVERIFY(draw());
        m_session->hits().remove(3);
        QVERIFY(draw());
        m_session->hits().remove(kMany - 20);
        QVERIFY(draw());
        QVERIFY(m_session->hits().add(m_session->hits().history().hits()[7]).ok());
        QVERIFY(draw());
        QVERIFY(m_gpu->sync());
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});

        QVERIFY(m_session->hits().add(scatteredOver(*m_session, kMany)).ok());
        QVERIFY(draw());
        const TaskList::Task* task = m_session->tasks().current();
        QVERIFY(task != nullptr);
        m_session->tasks().cancel(task->id);
        for (int frame = 0; frame < 5000 && (frame < 2 || m_gpu->isReadBackPending()); ++frame) {
            QVERIFY(draw());
        }
        QCOMPARE(m_session->hits().history().size(), kMany - 1);
        QCOMPARE(wrongVertices(*m_session), std::size_t{0});
    }

private:
    void begin(PipelineKind kind) {
        m_gpu.reset();
        m_session = std::make_unique<Session>();
        loadMesh(*m_session, makeHighPolySphere(2.5f));
        m_session->settings().setPipeline(kind);
        m_gpu = SceneGpu::create(*m_session).value();
        QVERIFY(m_gpu->sync());
    }
    bool draw() {
        SceneGpu::View view;
        view.width = 64;
        view.height = 48;
        return m_gpu->draw(view, m_target->framebuffer()).ok();
    }

    test::GlFixture m_gl;
    std::optional<gl::RenderTarget> m_target;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;
};

HITSCOPE_TEST(SlicedHitsTest, QCoreApplication)

}  // namespace hitscope::sliced_hits_test

#include "sliced_hits_test.moc"
