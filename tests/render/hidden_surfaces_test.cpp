// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that are behind what has been drawn are passed over: fewer are drawn, and the picture stays the
// same.
#include <epoxy/gl.h>

#include <QTest>
#include <glm/geometric.hpp>

#include "drawn_share_support.h"
#include "gl/pipeline_rows.h"
#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::hidden_surfaces_test {

using namespace test;

namespace {

constexpr float kRadius = 2.5f;
constexpr int kWidth = 240;
constexpr int kHeight = 160;

/// Dense: the back half has more triangles than are drawn without a look at what hides them.
MeshData denseSphere() {
    return makeUvSphere(360, 240, kRadius);
}

/// With as many holes as not: transparent squares.
Image chequered() {
    constexpr int kSize = 16;
    Image image;
    image.width = kSize;
    image.height = kSize;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const std::uint8_t alpha = ((x / 4 + y / 4) % 2) != 0 ? 255 : 0;
            image.pixels.insert(image.pixels.end(), {200, 180, 90, alpha});
        }
    }
    return image;
}

}  // namespace

class HiddenSurfacesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_renderer.reset(); }
    void fewerAndTheSame_data();
    void fewerAndTheSame();
    void throughHoles();
    void behindAnother();
    void withSamplesAllOfThem();

private:
    [[nodiscard]] Drawn draw(const Frame& frame, DeformationPipeline& pipeline, int samples = 1) {
        return drawCounted(*m_renderer, frame, pipeline, samples);
    }
    [[nodiscard]] double share(const Frame& frame, DeformationPipeline& pipeline, int samples = 1) {
        return drawnShare(*m_renderer, frame, pipeline, samples);
    }
    /// Whether there are pictures of more than one sample a pixel.
    [[nodiscard]] static bool hasSamples() {
        GLint most = 0;
        glGetIntegerv(GL_MAX_SAMPLES, &most);
        return most > 1;
    }
    [[nodiscard]] static bool isSoftware() { return gl::rendererInfo().isSoftware(); }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
};

void HiddenSurfacesTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
}

void HiddenSurfacesTest::fewerAndTheSame_data() {
    QTest::addColumn<PipelineKind>("kind");
    QTest::addColumn<QString>("what");
    for (const char* what : {"whole", "cut", "wiped", "flat", "orthographic", "close", "beside", "change"}) {
        QTest::addRow("%s", what) << PipelineKind::TransformFeedback << QString::fromLatin1(what);
    }
    QTest::newRow("uniform array") << PipelineKind::UniformArray << QStringLiteral("whole");
}

void HiddenSurfacesTest::fewerAndTheSame() {
    QFETCH(PipelineKind, kind);
    QFETCH(QString, what);
    HITSCOPE_NEEDS_EXACT_ARITHMETIC();
    TestScene scene;
    scene.add(*m_renderer, denseSphere(), glm::vec3(0));
    const auto pipeline = scene.pipeline(kind, deepDents());
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.options.shadows = false;  // their maps have triangles of their own
    frame.options.flat = what == QStringLiteral("flat");
    frame.options.cut.on = what == QStringLiteral("cut");
    frame.options.beforeAfter.wipe = what == QStringLiteral("wiped");
    if (what == QStringLiteral("orthographic")) {
        frame.camera.setProjection(Projection::Orthographic);
    } else if (what == QStringLiteral("close")) {
        frame.camera.setPivot(glm::vec3(0.0f, 0.0f, kRadius), 0.3f, 0.2f, 1.5f);
    } else if (what == QStringLiteral("beside")) {
        frame.width = kWidth / 2;
        frame.left = kWidth / 2;
    } else if (what == QStringLiteral("change")) {
        frame.change = ShownChange{};
    }
    const double drawn = share(frame, *pipeline);
    QVERIFY2(drawn > 0.0, "another picture");
    if (isSoftware()) {
        const double most = frame.options.cut.on ? 0.98 : 0.8;  // through a cut one sees the back
        QVERIFY2(drawn < most, qPrintable(QString::number(drawn)));
    }
}

/// Where the nearer half has holes, the farther one is seen.
void HiddenSurfacesTest::throughHoles() {
    TestScene scene;
    scene.add(*m_renderer, denseSphere(), glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    std::vector<DrawItem> items(scene.items().begin(), scene.items().end());
    const std::shared_ptr<const MaterialSet> cover = m_renderer->makeCover(chequered());
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.options.shadows = false;
    const Drawn closed = draw(frame, *pipeline);
    items[0].materials = cover.get();
    frame.targets = items;
    QVERIFY(share(frame, *pipeline) > 0.0);
    QVERIFY(closed.primitives == 0 || draw(frame, *pipeline).primitives > closed.primitives);
}

void HiddenSurfacesTest::behindAnother() {
    TestScene scene;
    scene.add(*m_renderer, denseSphere(), glm::vec3(0));
    scene.add(*m_renderer, makeUvSphere(360, 240, 0.5f * kRadius), glm::vec3(0.0f, 0.0f, -2.0f * kRadius));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, deepDents());
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.options.shadows = false;
    frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 4.0f * kRadius);
    const double drawn = share(frame, *pipeline);
    QVERIFY(drawn > 0.0);
    if (isSoftware()) {
        QVERIFY2(drawn < 0.6, qPrintable(QString::number(drawn)));
    }
}

/// Their depths cannot be read.
void HiddenSurfacesTest::withSamplesAllOfThem() {
    TestScene scene;
    scene.add(*m_renderer, denseSphere(), glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.options.shadows = false;
    const double drawn = share(frame, *pipeline, 4);
    QVERIFY(drawn > 0.0);
    if (draw(frame, *pipeline, 4).primitives > 0 && hasSamples()) {
        QCOMPARE(drawn, 1.0);
    }
}

HITSCOPE_TEST(HiddenSurfacesTest, QCoreApplication)

}  // namespace hitscope::hidden_surfaces_test

#include "hidden_surfaces_test.moc"
