// SPDX-License-Identifier: GPL-3.0-or-later
// Shadow maps grow with what bulges, and a picture of before has the texels of before.
#include <QTest>

#include "scene/refined_view.h"
#include "scene_draw_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_patch_bulge_test {

using namespace test;

class ScenePatchBulgeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        m_gl.open();
        if (!gl::rendererInfo().isSoftware()) {
            QSKIP("only software renderers patch pictures");
        }
    }
    void cleanup() {
        m_refined.reset();
        m_gpu.reset();
        m_session.reset();
        QCOMPARE(m_gl.errors(), QStringList());
    }

    void isTheWholePicture_data() {
        QTest::addColumn<bool>("prepared");
        QTest::newRow("at once") << false;
        QTest::newRow("in steps, as in the window") << true;
    }
    void isTheWholePicture() {
        QFETCH(bool, prepared);
        open();
        QVERIFY(!drawn(*m_gpu, m_view, m_refined.get()).pixels.empty());
        QVERIFY(m_refined->isPlain());
        for (const float length : {0.2f, 4.0f, 0.2f, 9.0f}) {
            QVERIFY(spike(length).ok());
            bool isBehind = true;
            for (int pictures = 0; isBehind && pictures < 100; ++pictures) {
                while (prepared && !prepare()) {
                }
                const Image patched = drawn(*m_gpu, m_view, m_refined.get());
                isBehind = m_gpu->isReadBackPending();
                if (!isBehind) {
                    QVERIFY(patched.pixels == drawn(*m_gpu, m_view).pixels);
                }
            }
            QVERIFY(!isBehind);
        }
    }

private:
    void open() {
        m_session = std::make_unique<Session>();
        std::vector<TargetPlan> plans(2, planPrimitive({PrimitiveKind::UvSphere, 24, 12.0f}));
        plans[1].transform.position.x = 14.0f;
        m_session->loadScene({{}, std::move(plans), 0.0f});
        m_session->targets().select({});
        m_refined = std::make_unique<RefinedView>(RefinedView::Pixels::UntilSettled);
        auto created = SceneGpu::create(*m_session);
        QVERIFY(created);
        m_gpu = std::move(created).value();
        m_view = smallView(*m_session, true);
        m_view.isAtRest = true;
        QVERIFY(m_gpu->sync().ok());
    }
    /// Sideways, so that it lies beside what the light sees of the originals.
    [[nodiscard]] Status spike(float length) {
        Hit hit;
        hit.target = m_session->targets()[1]->id;
        hit.point = {6.0f, 0.0f, 0.0f};
        hit.direction = {1.0f, 0.0f, 0.0f};
        hit.constants = {.maxDistance = 2.0f, .power = 20.0f, .maxMagnitude = length};
        return m_session->hits().add(hit);
    }
    /// Returns whether nothing is left to do, or nothing could be done.
    [[nodiscard]] bool prepare() {
        const Result<bool> done = m_gpu->prepare(m_view, m_refined.get());
        return !done || done.value();
    }

    GlFixture m_gl;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;
    std::unique_ptr<RefinedView> m_refined;
    SceneGpu::View m_view;
};

HITSCOPE_TEST(ScenePatchBulgeTest, QCoreApplication)

}  // namespace hitscope::scene_patch_bulge_test

#include "scene_patch_bulge_test.moc"
