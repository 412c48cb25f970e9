// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of wireframes that are behind surfaces are passed over: fewer are drawn, and the picture stays the
// same.
#include <epoxy/gl.h>

#include <QTest>

#include "drawn_share_support.h"
#include "gl/pipeline_rows.h"
#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::hidden_lines_test {

using namespace test;

namespace {

constexpr float kRadius = 2.5f;
constexpr int kWidth = 480;
constexpr int kHeight = 320;

/// Its edges are drawn as lines of a pixel, and too few of its triangles are hidden to be passed over.
MeshData sphereOfShortEdges() {
    return makeUvSphere(160, 100, kRadius);
}

/// Its edges are drawn as wide lines.
MeshData sphereOfLongEdges() {
    return makeUvSphere(96, 64, kRadius);
}

}  // namespace

class HiddenLinesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_renderer = openRenderer(m_gl); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_renderer.reset(); }
    void fewerAndTheSame_data();
    void fewerAndTheSame();
    void behindAnother();
    void asFarAsLinesReach_data();
    void asFarAsLinesReach();

private:
    static Frame frameWith(const TestScene& scene, WireframeMode mode) {
        Frame frame = frameOf(scene, kWidth, kHeight);
        frame.options.shadows = false;  // their maps have triangles of their own
        frame.options.wireframe = mode;
        return frame;
    }
    [[nodiscard]] static bool isSoftware() { return gl::rendererInfo().isSoftware(); }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
};

void HiddenLinesTest::fewerAndTheSame_data() {
    QTest::addColumn<MeshData>("mesh");
    QTest::addColumn<WireframeMode>("mode");
    QTest::addColumn<QString>("what");
    for (const char* what : {"whole", "cut", "wiped", "orthographic", "close", "beside", "dense pixels"}) {
        const QString text = QString::fromLatin1(what);
        QTest::addRow("over, %s", what) << sphereOfLongEdges() << WireframeMode::Over << text;
        QTest::addRow("only, %s", what) << sphereOfLongEdges() << WireframeMode::Only << text;
    }
    QTest::newRow("over, short") << sphereOfShortEdges() << WireframeMode::Over << QStringLiteral("whole");
    QTest::newRow("only, short") << sphereOfShortEdges() << WireframeMode::Only << QStringLiteral("whole");
}

void HiddenLinesTest::fewerAndTheSame() {
    QFETCH(MeshData, mesh);
    QFETCH(WireframeMode, mode);
    QFETCH(QString, what);
    HITSCOPE_NEEDS_EXACT_ARITHMETIC();
    TestScene scene;
    scene.add(*m_renderer, mesh, glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, deepDents());
    Frame frame = frameWith(scene, mode);
    frame.options.cut.on = what == QStringLiteral("cut");
    frame.options.beforeAfter.wipe = what == QStringLiteral("wiped");
    frame.pixelRatio = what == QStringLiteral("dense pixels") ? 2.0f : 1.0f;
    if (what == QStringLiteral("orthographic")) {
        frame.camera.setProjection(Projection::Orthographic);
    } else if (what == QStringLiteral("close")) {
        frame.camera.setPivot(glm::vec3(0.0f, 0.0f, kRadius), 0.3f, 0.2f, 2.5f);
    } else if (what == QStringLiteral("beside")) {
        frame.width = kWidth / 2;
        frame.left = kWidth / 2;
    }
    const double drawn = drawnShare(*m_renderer, frame, *pipeline);
    QVERIFY2(drawn > 0.0, "another picture");
    if (isSoftware() && !frame.options.cut.on) {  // through a cut one sees the back
        QVERIFY2(drawn < 0.98, qPrintable(QString::number(drawn)));
    }
}

void HiddenLinesTest::behindAnother() {
    HITSCOPE_NEEDS_EXACT_ARITHMETIC();
    TestScene scene;
    scene.add(*m_renderer, sphereOfLongEdges(), glm::vec3(0));
    scene.add(*m_renderer, makeUvSphere(96, 64, 0.5f * kRadius), glm::vec3(0.0f, 0.0f, -2.0f * kRadius));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, deepDents());
    Frame frame = frameWith(scene, WireframeMode::Over);
    frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 3.0f * kRadius);
    const double drawn = drawnShare(*m_renderer, frame, *pipeline);
    QVERIFY2(drawn > 0.0, "another picture");
    if (isSoftware()) {
        QVERIFY2(drawn < 0.92, qPrintable(QString::number(drawn)));
    }
}

void HiddenLinesTest::asFarAsLinesReach_data() {
    QTest::addColumn<float>("half");    // of a cube behind the front face of one of 2 m
    QTest::addColumn<float>("pixels");  // that its front face is behind that
    QTest::newRow("beyond the outline") << 1.99f << 200.0f;
    QTest::newRow("to the front") << 1.9f << 0.5f;
}

/// Lines are seen beside a face that ends where they are, and through one that is close before them.
void HiddenLinesTest::asFarAsLinesReach() {
    QFETCH(float, half);
    QFETCH(float, pixels);
    HITSCOPE_NEEDS_EXACT_ARITHMETIC();
    constexpr float kFront = 2.0f;
    Camera camera;
    camera.setSceneRadius(20.0f);
    camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 4.5f);
    camera.setProjection(Projection::Orthographic);
    const float pixel = camera.heightAt(4.5f) / static_cast<float>(kHeight);
    TestScene scene;
    scene.add(*m_renderer, makeCube(160, kFront), glm::vec3(0));  // its own edges are too short to be drawn
    scene.add(*m_renderer, makeCube(30, half), glm::vec3(0.0f, 0.0f, kFront - pixels * pixel - half));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame frame = frameWith(scene, WireframeMode::Over);
    frame.camera = camera;
    frame.options.floor = false;
    frame.options.theme = Theme::Light;  // whose background is not as dark as lines
    Frame alone = frame;
    alone.targets = scene.items().first(1);
    const double drawn = drawnShare(*m_renderer, frame, *pipeline);
    QVERIFY2(drawn > 0.0, "another picture");
    QVERIFY(differing(drawCounted(*m_renderer, frame, *pipeline).picture,
                      drawCounted(*m_renderer, alone, *pipeline).picture) > 100);
}

HITSCOPE_TEST(HiddenLinesTest, QCoreApplication)

}  // namespace hitscope::hidden_lines_test

#include "hidden_lines_test.moc"
