// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of a refined picture are drawn only where they can differ. Drawn everywhere they come to the same
// picture.
#include <QSize>
#include <QTest>
#include <memory>

#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render/refined/refined_picture.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::refined_area_test {

using namespace test;

namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 180;

}  // namespace

class RefinedAreaTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase();
    void alikeOutside_data();
    void alikeOutside();
    void wholeWhereItMustBe_data();
    void wholeWhereItMustBe();

private:
    struct Refined {
        QImage image;
        PixelArea area;
    };
    [[nodiscard]] Frame frame(const DisplayOptions& options) const;
    [[nodiscard]] Refined refined(const Frame& frame, RefinedPicture::Extent extent, int samples);

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<TestScene> m_scene;
    std::unique_ptr<DeformationPipeline> m_pipeline;
};

void RefinedAreaTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
    if (!m_renderer) {
        return;
    }
    // Its walls keep light away from the floor beside them.
    m_scene = std::make_unique<TestScene>();
    m_scene->add(*m_renderer, makeCube(8, 2.5f), glm::vec3(0.0f, 2.5f, 0.0f));
    m_pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
}

void RefinedAreaTest::cleanupTestCase() {
    m_pipeline.reset();
    m_scene.reset();
    m_renderer.reset();
}

Frame RefinedAreaTest::frame(const DisplayOptions& options) const {
    Frame made = frameOf(*m_scene, kWidth, kHeight);
    made.camera.zoom(1.6f);
    made.options = options;
    made.meshRevision = 1;
    return made;
}

RefinedAreaTest::Refined RefinedAreaTest::refined(const Frame& frame, RefinedPicture::Extent extent,
                                                  int samples) {
    RefinedPicture summed(extent);
    while (summed.samples() < samples) {
        if (const Status added = m_renderer->refine(frame, *m_pipeline, summed); !added) {
            QTest::qFail(added.error().message().c_str(), __FILE__, __LINE__);
            return {};
        }
    }
    const gl::RenderTarget target(frame.width, frame.height, 1);
    if (!m_renderer->drawRefined(frame, *m_pipeline, summed, target.framebuffer()).ok()) {
        QTest::qFail("nothing is drawn", __FILE__, __LINE__);
        return {};
    }
    const Image image = target.read();
    return {QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy(),
            summed.area()};
}

void RefinedAreaTest::alikeOutside_data() {
    QTest::addColumn<float>("turn");
    QTest::addColumn<float>("height");
    QTest::addColumn<float>("aslant");  // how far the light goes aside on its way down; 0: no shadows
    QTest::addColumn<bool>("orthographic");
    for (const bool orthographic : {false, true}) {
        const char* name = orthographic ? "orthographic" : "perspective";
        QTest::addRow("%s, no shadows", name) << 0.4f << 0.6f << 0.0f << orthographic;
        QTest::addRow("%s, straight before a wall", name) << -0.6f << 0.4f << 0.0f << orthographic;
        QTest::addRow("%s, high light", name) << 0.3f << 0.2f << 0.3f << orthographic;
        QTest::addRow("%s, low light", name) << 2.1f << 0.5f << 1.0f << orthographic;
        QTest::addRow("%s, long shadow", name) << -1.2f << 0.9f << 2.0f << orthographic;
    }
}

void RefinedAreaTest::alikeOutside() {
    QFETCH(float, turn);
    QFETCH(float, height);
    QFETCH(float, aslant);
    QFETCH(bool, orthographic);
    Frame view = frame(DisplayOptions{.shadows = aslant > 0.0f});
    view.camera.setProjection(orthographic ? Projection::Orthographic : Projection::Perspective);
    view.camera.orbit(turn, height);
    view.lights.directional.direction = glm::vec3(aslant, -1.0f, 0.4f * aslant);
    const Refined within = refined(view, RefinedPicture::Extent::WhereItVaries, 16);
    const Refined everywhere = refined(view, RefinedPicture::Extent::Everywhere, 16);
    QCOMPARE(QSize(everywhere.area.width, everywhere.area.height), QSize(kWidth, kHeight));
    // The floor's colours are kept in eight bits each.
    QCOMPARE(differing(within.image, everywhere.image, 1), 0);
    QVERIFY2(within.area.width * within.area.height < kWidth * kHeight * 9 / 10,
             qPrintable(QStringLiteral("%1 x %2").arg(within.area.width).arg(within.area.height)));
}

void RefinedAreaTest::wholeWhereItMustBe_data() {
    QTest::addColumn<DisplayOptions>("options");
    QTest::addColumn<float>("aslant");
    QTest::addColumn<bool>("isWhole");
    const auto add = [](const char* name, const DisplayOptions& options, float aslant, bool isWhole) {
        QTest::newRow(name) << options << aslant << isWhole;
    };
    add("nothing of that", {.shadows = true}, 0.3f, false);
    add("wireframe", {.wireframe = WireframeMode::Only}, 0.3f, true);
    add("needles", {.needles = true}, 0.3f, true);
    add("dots", {.dots = true}, 0.3f, true);
    add("wipe", {.beforeAfter = {.wipe = true}}, 0.3f, true);
    add("ghost", {.beforeAfter = {.ghost = GhostMode::Wire}}, 0.3f, true);
    add("shadows as far as one sees", {.shadows = true}, 20.0f, true);
    add("no shadows of that light", {.shadows = false}, 20.0f, false);
}

void RefinedAreaTest::wholeWhereItMustBe() {
    QFETCH(DisplayOptions, options);
    QFETCH(float, aslant);
    QFETCH(bool, isWhole);
    Frame view = frame(options);
    view.lights.directional.direction = glm::vec3(aslant, -1.0f, 0.0f);
    const PixelArea area = refined(view, RefinedPicture::Extent::WhereItVaries, 1).area;
    QCOMPARE(QSize(area.width, area.height) == QSize(kWidth, kHeight), isWhole);
}

HITSCOPE_TEST(RefinedAreaTest, QCoreApplication)

}  // namespace hitscope::refined_area_test

#include "refined_area_test.moc"
