// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::wireframe_test {

using namespace test;

class WireframeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void cleanupTestCase();
    void modesDiffer();
    void linesAreWiderOnDenseScreens();
    void hiddenEdgesAreHidden_data();
    void hiddenEdgesAreHidden();

private:
    [[nodiscard]] QImage draw(const Frame& frame, WireframeMode mode) {
        Frame changed = frame;
        changed.options.wireframe = mode;
        return picture(*m_renderer, changed, *m_pipeline);
    }
    Frame show(const MeshData& mesh) {
        m_pipeline.reset();
        m_scene = std::make_unique<TestScene>();
        m_scene->add(*m_renderer, mesh, glm::vec3(0));
        m_pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
        Frame frame = frameOf(*m_scene, 320, 240);
        frame.options.floor = false;
        return frame;
    }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<TestScene> m_scene;
    std::unique_ptr<DeformationPipeline> m_pipeline;
};

void WireframeTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
}

void WireframeTest::cleanup() {
    QCOMPARE(m_gl.errors(), QStringList());
}

void WireframeTest::cleanupTestCase() {
    m_pipeline.reset();
    m_scene.reset();
    m_renderer.reset();
}

void WireframeTest::modesDiffer() {
    const Frame frame = show(makeHighPolySphere());
    const QImage off = draw(frame, WireframeMode::Off);
    const QImage over = draw(frame, WireframeMode::Over);
    const QImage only = draw(frame, WireframeMode::Only);
    QVERIFY(differing(off, over, 8) > 1000);
    QVERIFY(differing(over, only, 8) > 1000);
    QVERIFY(differing(off, only, 8) > 1000);
}

void WireframeTest::linesAreWiderOnDenseScreens() {
    Frame frame = show(makeUvSphere(6, 4, 2.5f));
    Frame empty = frame;
    empty.targets = {};
    const QImage background = draw(empty, WireframeMode::Only);
    const int narrow = differing(draw(frame, WireframeMode::Only), background, 40);
    frame.pixelRatio = 2.0f;
    const int wide = differing(draw(frame, WireframeMode::Only), background, 40);
    QVERIFY2(narrow > 500 && wide > narrow * 3 / 2, qPrintable(QString("%1, %2").arg(narrow).arg(wide)));
}

void WireframeTest::hiddenEdgesAreHidden_data() {
    QTest::addColumn<float>("distance");
    QTest::newRow("near") << 6.0f;
    QTest::newRow("far") << 60.0f;
    QTest::newRow("very far") << 400.0f;
}

void WireframeTest::hiddenEdgesAreHidden() {
    // A cube seen straight on, as large in the picture at any distance: its far edges lie behind its near
    // face.
    QFETCH(float, distance);
    const float half = 0.15f * distance;
    Frame frame = show(makeCube(1, half));
    frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, distance);
    // As far as the scene goes, what decides on the precision of depth is the same for all.
    frame.camera.setSceneRadius(std::max(72.0f, distance));
    const QImage off = draw(frame, WireframeMode::Off);
    const QImage over = draw(frame, WireframeMode::Over);
    QVERIFY(differing(off, over, 8) > 200);
    const float face = half / (distance - half) / std::tan(0.5f * frame.camera.fieldOfView()) * 120.0f;
    const int inner = static_cast<int>(face) - 3;
    const QRect inside(160 - inner, 120 - inner, 2 * inner, 2 * inner);
    QCOMPARE(differing(off.copy(inside), over.copy(inside)), 0);
    // Without surfaces they are dimmed, not gone.
    Frame empty = frame;
    empty.targets = {};
    const QImage only = draw(frame, WireframeMode::Only);
    const QImage background = draw(empty, WireframeMode::Only);
    QVERIFY(differing(only.copy(inside), background.copy(inside), 2) > 100);
    // But for the corners, where three lines end in one pixel.
    QVERIFY(differing(only.copy(inside), background.copy(inside), 60) <= 4);
}

HITSCOPE_TEST(WireframeTest, QCoreApplication)

}  // namespace hitscope::wireframe_test

#include "wireframe_test.moc"
