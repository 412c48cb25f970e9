// SPDX-License-Identifier: GPL-3.0-or-later
// Coarse pictures, as of a window in motion: their shadow map is drawn again only where hits have moved
// something.
#include <QTest>
#include <glm/geometric.hpp>

#include "scene_draw_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_coarse_patch_test {

using namespace test;

class SceneCoarsePatchTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() {
        m_gpu.reset();
        m_session.reset();
        QCOMPARE(m_gl.errors(), QStringList());
    }

    void shadowsAreThoseDrawnAnew() {
        open();
        const Image whole = draw();
        QVERIFY(m_gpu->wasCoarse());
        QVERIFY(hit({1.2f, 5.7f, 1.6f}).ok());
        const Image first = draw();
        QVERIFY(first.pixels != whole.pixels);
        QVERIFY(first.pixels == drawAnew().pixels);
        QVERIFY(hit({-4.8f, 3.2f, 1.6f}).ok());
        QVERIFY(draw().pixels == drawAnew().pixels);
        m_session->undo();
        QVERIFY(draw().pixels == first.pixels);
        m_session->undo();
        QVERIFY(draw().pixels == whole.pixels);
    }

    void drawsFewerTriangles() {
        open();
        const GLuint all = primitivesOf([this] { static_cast<void>(draw()); });
        if (all == 0) {
            QSKIP("this renderer does not count what it draws");
        }
        const GLuint none = primitivesOf([this] { static_cast<void>(draw()); });
        QVERIFY(hit({1.2f, 5.7f, 1.6f}).ok());
        const GLuint some = primitivesOf([this] { static_cast<void>(draw()); });
        QVERIFY2(some > none && 4 * (some - none) < all - none,
                 qPrintable(QStringLiteral("%1 between %2 and %3").arg(some).arg(none).arg(all)));
    }

private:
    void open() {
        m_session = std::make_unique<Session>();
        std::vector<TargetPlan> plans(1, planPrimitive({PrimitiveKind::UvSphere, 400, 12.0f}));
        m_session->loadScene({{}, std::move(plans), 0.0f});
        m_session->targets().select({});
        auto created = SceneGpu::create(*m_session);
        QVERIFY(created);
        m_gpu = std::move(created).value();
        m_view = smallView(*m_session, true);
        m_view.detail.coarse = true;
        QVERIFY(m_gpu->sync().ok());
    }
    [[nodiscard]] Image draw() {
        const bool isSynced = m_gpu->sync().ok();  // normals have come, too
        return isSynced ? drawn(*m_gpu, m_view) : Image();
    }
    /// With a light that was elsewhere meanwhile, so that nothing of the map stays.
    [[nodiscard]] Image drawAnew() {
        const Lights lights = m_session->settings().lights();
        Lights others = lights;
        others.directional.direction.x += 0.2f;
        m_session->settings().setLights(others);
        static_cast<void>(draw());
        m_session->settings().setLights(lights);
        Image picture = draw();
        m_session->undo();
        m_session->undo();
        return picture;
    }
    [[nodiscard]] Status hit(const glm::vec3& point) {
        Hit hit;
        hit.target = m_session->targets()[0]->id;
        hit.point = point;
        hit.direction = -glm::normalize(point);
        hit.constants = {.maxDistance = 0.8f, .power = 2.0f, .maxMagnitude = 0.8f};
        return m_session->hits().add(hit);
    }

    GlFixture m_gl;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;
    SceneGpu::View m_view;
};

HITSCOPE_TEST(SceneCoarsePatchTest, QCoreApplication)

}  // namespace hitscope::scene_coarse_patch_test

#include "scene_coarse_patch_test.moc"
