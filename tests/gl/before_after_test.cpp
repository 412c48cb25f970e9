// SPDX-License-Identifier: GPL-3.0-or-later
// The original beside what became of it: wipe, ghosts, exaggeration.
#include <QTest>
#include <glm/geometric.hpp>

#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::before_after_test {

namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 150;

}  // namespace

class BeforeAfterTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() {
        m_scene.reset();
        QCOMPARE(m_gl.errors(), QStringList());
    }

    void wipeIsTheOriginalLeftAndTheDeformedRight_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("wireframe");
        QTest::addColumn<bool>("shadows");
        for (const PipelineKind kind : {PipelineKind::TransformFeedback, PipelineKind::UniformArray}) {
            for (const WireframeMode mode : {WireframeMode::Off, WireframeMode::Over, WireframeMode::Only}) {
                QTest::addRow("%s, %d", std::string(pipelineTraits(kind).key).c_str(), static_cast<int>(mode))
                    << static_cast<int>(kind) << static_cast<int>(mode) << false;
            }
        }
        QTest::addRow("shadows") << static_cast<int>(PipelineKind::TransformFeedback)
                                 << static_cast<int>(WireframeMode::Off) << true;
    }
    void wipeIsTheOriginalLeftAndTheDeformedRight() {
        QFETCH(int, kind);
        QFETCH(int, wireframe);
        QFETCH(bool, shadows);
        Session session;
        open(session, makeHighPolySphere(), static_cast<PipelineKind>(kind));
        m_view.options.wireframe = static_cast<WireframeMode>(wireframe);
        m_view.options.shadows = shadows;
        const QImage before = picture();
        bulge(session);
        dent(session);
        const QImage after = picture();
        QVERIFY(test::differing(before, after, 4) > 100);
        for (const float at : {0.0f, 0.3f, 0.5f, 1.0f}) {
            m_view.options.beforeAfter.wipe = true;
            m_view.options.beforeAfter.wipeAt = at;
            const QImage wiped = picture();
            const int line = static_cast<int>(std::lround(at * kWidth));
            QCOMPARE(wiped.copy(0, 0, line, kHeight), before.copy(0, 0, line, kHeight));
            QCOMPARE(wiped.copy(line, 0, kWidth - line, kHeight),
                     after.copy(line, 0, kWidth - line, kHeight));
        }
    }

    void ghostsShowWhereSomethingMoved_data() {
        QTest::addColumn<int>("mode");
        QTest::addRow("wire") << static_cast<int>(GhostMode::Wire);
        QTest::addRow("translucent") << static_cast<int>(GhostMode::Translucent);
    }
    void ghostsShowWhereSomethingMoved() {
        QFETCH(int, mode);
        Session session;
        open(session, makeHighPolySphere(), PipelineKind::TransformFeedback);
        const QImage before = picture();
        m_view.options.beforeAfter.ghost = static_cast<GhostMode>(mode);
        QCOMPARE(picture(), before);  // nothing has moved
        dent(session);
        const QImage ghost = picture();
        m_view.options.beforeAfter.ghost = GhostMode::Off;
        const QImage after = picture();
        const int seen = test::differing(ghost, after, 4);
        QVERIFY2(seen > 50 && seen < kWidth * kHeight / 4, qPrintable(QString::number(seen)));
        session.hits().clear();
        m_view.options.beforeAfter.ghost = static_cast<GhostMode>(mode);
        picture();
        QCOMPARE(picture(), before);
    }

    /// As a mesh that is moved so far looks.
    void exaggerationMovesVertices_data() {
        QTest::addColumn<int>("kind");
        QTest::addRow("feedback") << static_cast<int>(PipelineKind::TransformFeedback);
        QTest::addRow("uniform array") << static_cast<int>(PipelineKind::UniformArray);
    }
    void exaggerationMovesVertices() {
        QFETCH(int, kind);
        constexpr float kFactor = 3.0f;
        Session session;
        // Edges so long that they are drawn as wide lines, which are the same from either end; hidden ones,
        // thin and faint, are not quite.
        open(session, makeUvSphere(32, 16, 2.5f), static_cast<PipelineKind>(kind));
        dent(session);
        const QImage plain = edges();
        m_view.options.beforeAfter.exaggeration = kFactor;
        const QImage exaggerated = edges();
        constexpr int kLine = 40;  // a usual edge's length, by which lines fade, is not quite the same
        const int moved = test::differing(plain, exaggerated, kLine);
        QVERIFY(moved > 50);
        MeshData mesh = session.targets()[0]->deformed.original();
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
            mesh.positions[v] += kFactor * session.targets()[0]->deformed.displacement(v);
        }
        const Camera camera = m_view.camera;
        ScenePlan plan;
        plan.targets.push_back(planMesh(mesh));
        plan.targets.front().transform = session.targets()[0]->transform;
        Session moving;
        open(moving, std::move(plan), PipelineKind::TransformFeedback);
        m_view.camera = camera;
        const int different = test::differing(edges(), exaggerated, kLine);
        QVERIFY2(different < moved / 10, qPrintable(QStringLiteral("%1 of %2").arg(different).arg(moved)));
    }

    /// What is exaggerated reaches far beyond the original, around which shadow maps are laid.
    void exaggeratedBulgesCastTheirShadows() {
        constexpr float kFactor = 4.0f;
        Session session;
        open(session, makeUvSphere(64, 32, 2.5f), PipelineKind::TransformFeedback);
        Hit hit;
        hit.target = session.targets()[0]->id;
        hit.point = {2.5f, 0.0f, 0.0f};
        hit.direction = {1.0f, 0.0f, 0.0f};
        hit.constants = {0.8f, 5.0f, 1.0f};
        QVERIFY(session.hits().add(hit).ok());
        m_view.camera.setPivot({1.0f, 0.0f, 0.0f}, 0.3f, 0.6f, 20.0f);
        m_view.options.beforeAfter.exaggeration = kFactor;
        const QImage exaggerated = shaded();
        MeshData mesh = session.targets()[0]->deformed.original();
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
            mesh.positions[v] += kFactor * session.targets()[0]->deformed.displacement(v);
        }
        const DisplayOptions options = m_view.options;
        const Camera camera = m_view.camera;
        ScenePlan plan;
        plan.targets.push_back(planMesh(mesh));
        plan.targets.front().transform = session.targets()[0]->transform;
        Session moved;
        open(moved, std::move(plan), PipelineKind::TransformFeedback);
        m_view.camera = camera;
        m_view.options = options;
        m_view.options.beforeAfter.exaggeration = 1.0f;
        const QImage whole = shaded();
        int inShadow = 0;
        int missing = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool isShaded = whole.pixelColor(x, y).red() > 0;
                inShadow += isShaded ? 1 : 0;
                missing += isShaded && exaggerated.pixelColor(x, y).red() == 0 ? 1 : 0;
            }
        }
        QVERIFY2(inShadow > 300, qPrintable(QString::number(inShadow)));
        QVERIFY2(missing < inShadow / 20, qPrintable(QStringLiteral("%1 of %2").arg(missing).arg(inShadow)));
    }

private:
    /// White where shadows fall.
    QImage shaded() {
        constexpr int kClearly = 12;  // levels
        m_view.options.shadows = false;
        const QImage lit = picture();
        m_view.options.shadows = true;
        const QImage shadowed = picture();
        QImage result(kWidth, kHeight, QImage::Format_RGB32);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const bool isDarker = qGreen(lit.pixel(x, y)) - qGreen(shadowed.pixel(x, y)) > kClearly;
                result.setPixel(x, y, isDarker ? qRgb(255, 255, 255) : qRgb(0, 0, 0));
            }
        }
        return result;
    }

    void open(Session& session, const MeshData& mesh, PipelineKind kind) {
        ScenePlan plan;
        plan.targets.push_back(planMesh(mesh));
        open(session, std::move(plan), kind);
    }

    void open(Session& session, ScenePlan plan, PipelineKind kind) {
        session.loadScene(std::move(plan));
        session.targets().select({});
        session.settings().setPipeline(kind);
        auto made = SceneGpu::create(session);
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
        m_scene = std::move(made).value();
        m_view = {};
        m_view.width = kWidth;
        m_view.height = kHeight;
        m_view.camera.frame(session.targets().bounds(), static_cast<float>(kWidth) / kHeight);
    }

    /// A spike towards the light, which casts a shadow that the original does not.
    void bulge(Session& session) {
        Hit hit;
        hit.target = session.targets()[0]->id;
        hit.direction = -glm::normalize(session.settings().lights().directional.direction);
        hit.point = 2.5f * hit.direction;
        hit.constants = {1.0f, 5.0f, 3.0f};
        QVERIFY(session.hits().add(hit).ok());
    }

    void dent(Session& session) {
        shootAll(session, demoShots(session, 25, 3));
        // Those that missed would be in the picture.
        for (int second = 0; second < 60 && session.simulation().physics().projectileCount() > 0; ++second) {
            session.simulation().advance(1.0);
        }
        QCOMPARE(session.simulation().physics().projectileCount(), std::size_t{0});
        session.targets().select({});
        QVERIFY(m_scene->sync());
    }

    QImage picture() {
        const gl::RenderTarget target(kWidth, kHeight);
        if (!m_scene->sync() || !m_scene->draw(m_view, target.framebuffer())) {
            QTest::qFail("nothing is drawn", __FILE__, __LINE__);
            return {};
        }
        const Image image = target.read();
        return QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
    }

    /// Edges only: they tell where vertices are, whatever their normals.
    QImage edges() {
        m_view.options.floor = false;
        m_view.options.wireframe = WireframeMode::Only;
        return picture();
    }

    test::GlFixture m_gl;
    std::unique_ptr<SceneGpu> m_scene;
    SceneGpu::View m_view;
};

HITSCOPE_TEST(BeforeAfterTest, QCoreApplication)

}  // namespace hitscope::before_after_test

#include "before_after_test.moc"
