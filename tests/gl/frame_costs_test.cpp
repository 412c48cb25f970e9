// SPDX-License-Identifier: GPL-3.0-or-later
// What SceneGpu reports about the frames it draws and the hits it applies.
#include "session/frame_costs.h"

#include <QTest>
#include <memory>

#include "gl/render_target.h"
#include "scene/scene_gpu.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::frame_costs_test {

namespace {

void addHits(Session& session, int count) {
    std::vector<Hit> hits(static_cast<std::size_t>(count));
    for (Hit& hit : hits) {
        hit.target = session.targets().front()->id;
        hit.point = {0.0f, 0.0f, 2.5f};
    }
    QVERIFY(session.hits().add(hits).ok());
}

}  // namespace

class FrameCostsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            m_picture = std::make_unique<gl::RenderTarget>(64, 48);
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_picture.reset(); }

    void hitsHaveCostsAfterFrames() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        SceneGpu& gpu = *made.value();
        const FrameCosts& costs = session.frameCosts();
        QVERIFY(costs.measuresGpu().has_value());

        drawFrame(gpu);
        addHits(session, 3);
        drawFrame(gpu);
        QCOMPARE(costs.frames().back().hits, 3u);
        QCOMPARE(costs.frames().back().history, 3u);
        addHits(session, 1);
        drawFrame(gpu);
        drawFrame(gpu);
        QCOMPARE(costs.frames().size(), std::size_t{4});
        QCOMPARE(costs.frames().back().hits, 0u);
        for (std::size_t i = 0; i < costs.frames().size(); ++i) {
            const FrameCost& frame = costs.frames()[i];
            QVERIFY(frame.drawing > 0.0 && frame.deformation > 0.0 && frame.readBack > 0.0);
            QCOMPARE(frame.cpu, frame.physics + frame.deformation + frame.readBack + frame.drawing);
        }
        QCOMPARE(costs.hitCost(1).value_or(HitCost{}).together, std::size_t{3});
        QCOMPARE(costs.hitCost(3).value_or(HitCost{}).together, std::size_t{1});
        QVERIFY(costs.hitCost(0)->cpu > 0.0);

        glFinish();
        gpu.collectCosts();
        if (*costs.measuresGpu()) {
            for (std::size_t i = 0; i < costs.frames().size(); ++i) {
                QVERIFY(costs.frames()[i].gpu.has_value());
                QVERIFY(*costs.frames()[i].gpu >= *costs.frames()[i].gpuDeformation);
            }
            QVERIFY(costs.hitCost(0)->gpu && costs.hitCost(3)->gpu);
        }
    }

    void anotherPipelineAppliesAllHits() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        addHits(session, 2);
        drawFrame(*made.value());
        session.settings().setPipeline(PipelineKind::UniformArray);
        addHits(session, 2);
        QVERIFY(made.value()->sync().ok());
        const FrameCosts& costs = session.frameCosts();
        QCOMPARE(costs.frames().size(), std::size_t{1});  // nothing was drawn
        for (std::size_t hit = 0; hit < 4; ++hit) {
            QCOMPARE(costs.hitCost(hit).value_or(HitCost{}).pipeline, PipelineKind::UniformArray);
            QCOMPARE(costs.hitCost(hit)->together, std::size_t{4});
        }
    }

    void aChangeOfEarlierHitsIsNoCostOfTheirs() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        addHits(session, 3);
        drawFrame(*made.value());
        const std::optional<HitCost> before = session.frameCosts().hitCost(2);
        const std::size_t first = 0;
        session.hits().setEnabled({&first, 1}, false);
        drawFrame(*made.value());
        QCOMPARE(session.frameCosts().hitCost(2)->cpu, before->cpu);
        QCOMPARE(session.frameCosts().frames().back().hits, 0u);
    }

private:
    void drawFrame(SceneGpu& gpu) const {
        SceneGpu::View view;
        view.width = m_picture->width();
        view.height = m_picture->height();
        QVERIFY(gpu.draw(view, m_picture->framebuffer()).ok());
    }

    test::GlFixture m_gl;
    std::unique_ptr<gl::RenderTarget> m_picture;
};

HITSCOPE_TEST(FrameCostsTest, QCoreApplication)

}  // namespace hitscope::frame_costs_test

#include "frame_costs_test.moc"
